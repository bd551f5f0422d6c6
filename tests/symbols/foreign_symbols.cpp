// SPDX-License-Identifier: GPL-3.0-or-later
// Defines what symbols_test.cmake must complain about; linked with nothing.
extern "C" {
void GOMP_parallel();
void GOMP_parallel() {}
double SuiteSparse_time();
double SuiteSparse_time() { return 0; }
void dgemm_();
void dgemm_() {}
void dpotrf_();
void dpotrf_() {}
}
