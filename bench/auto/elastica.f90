! The fibre on its rig as AUTO takes it: a boundary value problem on half the fibre, from support (t = 0) to midspan (t = 1),
! with the arc length S between the supports as one of the unknowns. Reduced variables, as in src/fibre/elastica.h.
!
! U: x, y (down), slope θ, curvature κ.   PAR: 1 stage, 2 S, 3 F, 4 N the thrust along the span, 5 stiffness, 6 mu0,
! 7 amplitude, 8 wavelength.   q = μ(S) everywhere: the equilibrium curve of (4.28), on the rig of (4.29).

subroutine func(ndim, u, icp, par, ijac, f, dfdu, dfdp)
  implicit none
  integer, intent(in) :: ndim, icp(*), ijac
  double precision, intent(in) :: u(ndim), par(*)
  double precision, intent(out) :: f(ndim)
  double precision, intent(inout) :: dfdu(ndim, ndim), dfdp(ndim, *)
  double precision :: half, sine, cosine, moment

  half = 0.5d0 * par(2)
  sine = sin(u(3))
  cosine = cos(u(3))
  moment = 0.5d0 * par(3) * cosine + par(4) * sine  ! of the support's force, per length of fibre
  f = [half * cosine, half * sine, half * u(4), -half * moment]
  if (ijac == 0) return

  dfdu = 0
  dfdu(1, 3) = -half * sine
  dfdu(2, 3) = half * cosine
  dfdu(3, 4) = half
  dfdu(4, 3) = -half * (par(4) * cosine - 0.5d0 * par(3) * sine)
  if (ijac == 1) return

  dfdp(:, 1) = 0
  dfdp(:, 2) = 0.5d0 * [cosine, sine, u(4), -moment]
  dfdp(:, 3) = [0d0, 0d0, 0d0, -0.5d0 * half * cosine]
  dfdp(:, 4) = [0d0, 0d0, 0d0, -half * sine]
end subroutine func

subroutine bcnd(ndim, par, icp, nbc, u0, u1, fb, ijac, dbc)
  implicit none
  integer, intent(in) :: ndim, icp(*), nbc, ijac
  double precision, intent(in) :: par(*), u0(ndim), u1(ndim)
  double precision, intent(out) :: fb(nbc)
  double precision, intent(inout) :: dbc(nbc, *)
  double precision, parameter :: pi = 3.14159265358979324d0
  double precision :: sine, cosine, mu, mu_slope
  integer :: p

  sine = sin(u0(3))
  cosine = cos(u0(3))
  mu = par(6) * (1 + par(7) * cos(pi * par(2) / par(8)))  ! (4.25)
  mu_slope = -par(6) * par(7) * pi / par(8) * sin(pi * par(2) / par(8))
  fb = [u0(1), u0(2), u0(4), u1(1) - 0.5d0, u1(3), &
        par(4) * (cosine + mu * sine) - 0.5d0 * par(3) * (sine - mu * cosine), &  ! the support's force: P_t = -μ P_n
        par(5) * (par(1) - u1(2)) - par(3)]                                      ! the rig: k (w_s - w) = F
  if (ijac == 0) return

  p = 2 * ndim
  dbc(:, 1:p) = 0
  dbc(1, 1) = 1
  dbc(2, 2) = 1
  dbc(3, 4) = 1
  dbc(4, ndim + 1) = 1
  dbc(5, ndim + 3) = 1
  dbc(6, 3) = par(4) * (mu * cosine - sine) - 0.5d0 * par(3) * (cosine + mu * sine)
  dbc(7, ndim + 2) = -par(5)
  if (ijac == 1) return

  dbc(:, p + 1:p + 4) = 0
  dbc(6, p + 2) = (par(4) * sine + 0.5d0 * par(3) * cosine) * mu_slope
  dbc(6, p + 3) = -0.5d0 * (sine - mu * cosine)
  dbc(6, p + 4) = cosine + mu * sine
  dbc(7, p + 1) = par(5)
  dbc(7, p + 3) = -1
end subroutine bcnd

! The straight fibre solves the problem: it is where the test starts.
subroutine stpnt(ndim, u, par, t)
  implicit none
  integer, intent(in) :: ndim
  double precision, intent(inout) :: u(ndim), par(*)
  double precision, intent(in) :: t

  u = [0.5d0 * t, 0d0, 0d0, 0d0]
  par(1:8) = [0d0, 1d0, 0d0, 0d0, 30d0, 0.6d0, 0.4d0, 0.0628318530717958648d0]  ! Fig. 8
end subroutine stpnt

subroutine icnd
end subroutine icnd

subroutine fopt
end subroutine fopt

subroutine pvls
end subroutine pvls
