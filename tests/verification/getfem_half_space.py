"""Discrete half-space of elastic, perfectly plastic, associated Drucker-Prager material in GetFEM.

Axisymmetric, small strain, rigid frictionless parabola z = r^2/(2R) - d by penalty contact at the
surface quadrature points, backward Euler with the symbolic tangent of the weak-form language.
Outside a box that may yield the half-space is elastic and condensed once; on its far boundary the
displacement is Boussinesq's for the current force (zero at infinity).
Units inside: lengths b (about the contact radius at the peak), displacements b^2/R, stresses
E b/R, forces E b^3/R.  Results: delta/delta_y and F/F_y, delta mutual (twice the body's).
Sources: first yield, J. Wang et al. 2018, doi 10.1155/2018/6783791, eqs 8-13; point force,
Johnson, Contact Mechanics (1985), section 3.2; closed-form return to the cone and its apex,
de Souza Neto, Peric and Owen, Computational Methods for Plasticity (2008), chapter 8.
"""
import os
import time

for _name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ.setdefault(_name, "1")

import getfem as gf
import numpy as np
import scipy.sparse as sp
import scipy.sparse.linalg as sla
from scipy.optimize import minimize_scalar

gf.util("trace level", 0)

# level l: 10 * 2^l elements across the contact; steps: loading; release: unloading;
# far: domain size, box: size of the part that may yield, both in b; penalty in E/R.
DEFAULTS = dict(level=1, steps=40, release=15, far=200.0, box=4.0, penalty=1e4,
                element="Q8", gauss=2, contact_points=2)

ELEMENTS = {"Q8": "FEM_Q2_INCOMPLETE(2)", "Q9": "FEM_QK(2,2)"}
TOP = 1
CONTACT = "2*pi*X(1)*pen*pos_part(over)*Test_u(2)"


def cone(phi_deg, sigma_c):
    """alpha and k of sqrt(J2) + alpha I1 - k, compression meridian fitted to sigma_c."""
    s = np.sin(np.radians(phi_deg))
    alpha = 2.0 * s / (np.sqrt(3.0) * (3.0 - s))
    return alpha, sigma_c * (1.0 - np.sqrt(3.0) * alpha) / np.sqrt(3.0)


def first_yield(E, nu, phi, sigma_c, R, **_):
    """Force F_y [N] and mutual approach delta_y [m] at first yield on the axis under Hertz."""
    alpha, k = cone(phi, sigma_c)

    def load(u):
        t = u * np.arctan(1.0 / u)
        root_j2 = abs((1 + nu) * t + 1.5 / (1 + u * u) - (1 + nu)) / np.sqrt(3.0)
        return root_j2 - alpha * 2 * (1 + nu) * (1 - t)

    best = minimize_scalar(lambda u: -load(u), bounds=(0.05, 3.0), method="bounded",
                           options=dict(xatol=1e-10))
    p0 = k / load(best.x)
    c = p0 * (1 - nu * nu) / E
    return np.pi**3 * p0 * c * c * R * R / 6.0, np.pi**2 * c * c * R / 2.0


def graded(n, far, box, uniform):
    """Coordinates from 0 to far: size 1/n up to `uniform`, then growing; coarse mesh split n/10."""
    x = list(np.arange(0.0, uniform + 1e-9, 0.1))
    for end, growth in ((box, 1.22), (far, 1.6)):
        h = x[-1] - x[-2]
        count = max(1, int(round(np.log(1 + (end - x[-1]) * (growth - 1) / (h * growth))
                                 / np.log(growth))))
        span, start = growth ** np.arange(1, count + 1), x[-1]
        x += list(start + (end - start) * np.cumsum(span) / span.sum())
    x, split = np.array(x), n // 10
    fractions = np.arange(split) / split
    return np.append((x[:-1, None] + np.diff(x)[:, None] * fractions).ravel(), x[-1])


def point_force(nodes, nu):
    """Boussinesq's displacement (u_r, u_z up) at z <= 0 under a unit downward force, E = 1."""
    r, depth = nodes[0], -nodes[1]
    rho = np.hypot(r, depth)
    c = (1 + nu) / (2 * np.pi)
    u_r = c * (r * depth / rho**3 - (1 - 2 * nu) * r / (rho * (rho + depth)))
    return u_r, -c * (depth**2 / rho**3 + 2 * (1 - nu) / rho)


class HalfSpace:
    """The discrete half-space: a box that may yield, its elastic exterior condensed."""

    def __init__(self, nu, alpha, k, opt):
        self.opt = opt
        n = 10 * 2 ** opt["level"]
        r = graded(n, opt["far"], opt["box"], 1.2)
        z = graded(n, opt["far"], opt["box"], 0.6)
        mesh = gf.Mesh("cartesian", r, -z[::-1])
        cells = mesh.cvid()
        centres = np.array([mesh.pts_from_cvid([c])[0].mean(axis=1) for c in cells]).T
        inside = (centres[0] < opt["box"]) & (centres[1] > -opt["box"])
        inner, outer = cells[inside], cells[~inside]
        faces = mesh.outer_faces_with_direction([0.0, 1.0], 0.01)
        faces = faces[:, np.isin(faces[0], inner)]
        mesh.set_region(TOP, faces)

        fem = gf.Fem(ELEMENTS[opt["element"]])
        mf, mf_out = gf.MeshFem(mesh, 2), gf.MeshFem(mesh, 2)
        mf.set_fem(fem, inner)
        mf_out.set_fem(fem, outer)
        volume = gf.Integ("IM_GAUSS_PARALLELEPIPED(2,%d)" % (2 * opt["gauss"] - 1))
        mim, mim_out, mim_top = gf.MeshIm(mesh), gf.MeshIm(mesh), gf.MeshIm(mesh)
        mim.set_integ(volume, inner)
        # reduced integration would leave the long far elements near the axis an hourglass mode
        mim_out.set_integ(gf.Integ("IM_GAUSS_PARALLELEPIPED(2,5)"), outer)
        mim_top.set_integ(gf.Integ("IM_GAUSS_PARALLELEPIPED(2,%d)"
                                   % (2 * opt["contact_points"] - 1)), inner)
        points = gf.MeshImData(mim, -1, [4])
        self.mesh, self.mf, self.mim_top, self.points = mesh, mf, mim_top, points

        md = gf.Model("real")
        md.add_fem_variable("u", mf)
        md.add_im_data("ep", points)
        G, B = 0.5 / (1 + nu), 1 / (3 * (1 - 2 * nu))
        for name, value in dict(G=G, B=B, al=alpha, k=k, d=0.0, pen=opt["penalty"]).items():
            md.add_initialized_data(name, [value])
        # strain (rr, zz, hoop, 2 rz); I the trace, s = S e the deviatoric stress, J2 = e.(J e)
        trace = np.array([1.0, 1.0, 1.0, 0.0])
        S = 2 * G * (np.diag([1, 1, 1, 0.5]) - np.outer(trace, trace) / 3)
        md.add_initialized_data("I", trace)
        md.add_initialized_data("S", S, [4, 4])
        md.add_initialized_data("J", S @ np.diag([0.5, 0.5, 0.5, 1.0]) @ S, [4, 4])
        for name, text in (
                ("total", "[Grad_u(1,1);Grad_u(2,2);u(1)/X(1);Grad_u(1,2)+Grad_u(2,1)]"),
                ("test", "[Grad_Test_u(1,1);Grad_Test_u(2,2);Test_u(1)/X(1);"
                         "Grad_Test_u(1,2)+Grad_Test_u(2,1)]"),
                ("e", "(total-ep)"),  # trial elastic strain
                ("tr", "(I.e)"), ("q", "sqrt(e.(J*e)+1e-24)"),
                ("f", "(q+3*al*B*tr-k)"), ("dg", "(pos_part(f)/(G+9*al*al*B))"),
                # both branches: where q - G dg < 0 the state is the apex, s = 0, 3 al p = k
                ("shrink", "(pos_part(q-G*dg)/q)"),
                ("p", "(B*tr-3*al*B*dg-neg_part(q-G*dg)/(3*al))"),
                ("over", "(u(2)+d-sqr(X(1))/2)")):
            md.add_macro(name, text)
        md.add_nonlinear_term(mim, "2*pi*X(1)*((shrink*(S*e)+p*I).test)")
        md.add_nonlinear_term(mim_top, CONTACT, TOP)
        self.md = md
        # elastic strain left: deviator shrunk, trace p/B
        self.new_ep = "total-(shrink*(e-(tr/3)*I)+(p/(3*B))*I)"

        self._condense(nu, mf_out, mim_out)
        self.u, self.force, self.d = np.zeros(mf.nbdof()), 0.0, 0.0
        self.iterations, self.apex, self.reach = 0, 0, 0.0

    def _condense(self, nu, mf_out, mim_out):
        """Condense the elastic exterior; its far nodes move by F times the point-force field."""
        G, lame = 0.5 / (1 + nu), nu / ((1 + nu) * (1 - 2 * nu))
        form = ("2*pi*X(1)*(%.17g*(Grad_u(1,1)+Grad_u(2,2)+u(1)/X(1))*(Grad_Test_u(1,1)"
                "+Grad_Test_u(2,2)+Test_u(1)/X(1))+%.17g*(2*Grad_u(1,1)*Grad_Test_u(1,1)"
                "+2*Grad_u(2,2)*Grad_Test_u(2,2)+2*u(1)*Test_u(1)/sqr(X(1))+(Grad_u(1,2)"
                "+Grad_u(2,1))*(Grad_Test_u(1,2)+Grad_Test_u(2,1))))" % (lame, G))
        n = mf_out.nbdof()
        K = self._csc(gf.asm_generic(mim_out, 2, form, -1, "u", 1, mf_out, np.zeros(n)), n)
        far, box, tol = self.opt["far"], self.opt["box"], 1e-9

        def layout(mf):
            nodes = mf.basic_dof_nodes()
            component = np.arange(nodes.shape[1]) % 2
            return nodes, component, (component == 0) & (nodes[0] < tol)

        x_out, c_out, axis_out = layout(mf_out)
        x_in, c_in, axis_in = layout(self.mf)
        at_far = (x_out[0] > far * (1 - tol)) | (x_out[1] < -far * (1 - tol))
        shared = (x_out[0] < box * (1 + tol)) & (x_out[1] > -box * (1 + tol))
        key = {(round(a, 8), round(b, 8), c): i for i, (a, b, c) in enumerate(zip(*x_in, c_in))}
        D = np.where(at_far & ~axis_out)[0]
        S = np.where(shared & ~axis_out)[0]
        E = np.where(~at_far & ~shared & ~axis_out)[0]
        self.shared = np.array([key[(round(x_out[0, i], 8), round(x_out[1, i], 8), c_out[i])]
                                for i in S])
        assert len(np.unique(self.shared)) == len(S)
        field = np.where(c_out[D] == 0, *point_force(x_out[:, D], nu))
        factor = self._factor(K[E][:, E])
        right = np.column_stack((K[E][:, S].toarray(), K[E][:, D] @ field))
        inverse = factor.solve(right)
        condensed = K[S][:, E] @ inverse
        self.schur = K[S][:, S].toarray() - condensed[:, :-1]
        self.pull = np.zeros(self.mf.nbdof())
        self.pull[self.shared] = K[S][:, D] @ field - condensed[:, -1]
        m = self.mf.nbdof()
        rows, cols = np.meshgrid(self.shared, self.shared, indexing="ij")
        self.exterior = sp.csc_matrix((self.schur.ravel(), (rows.ravel(), cols.ravel())), (m, m))
        self.free = np.where(~axis_in)[0]
        self.x, self.lift = x_in, c_in.astype(float)

    @staticmethod
    def _csc(matrix, n):
        index = matrix.csc_ind()
        return sp.csc_matrix((matrix.csc_val(), index[1], index[0]), (n, n))

    @staticmethod
    def _factor(K):
        return sla.splu(K.tocsc(), permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=1e-3,
                        options=dict(SymmetricMode=True))

    def _contact(self, order):
        return gf.asm_generic(self.mim_top, order, CONTACT, TOP, self.md)

    def residual(self, u, what):
        self.md.set_variable("u", u)
        self.md.assembly(what)
        force = float(self._contact(1) @ self.lift)
        r = -self.md.rhs().ravel() + self.exterior @ u + force * self.pull
        return r[self.free], force

    def solve(self, d, guess):
        """Newton for the approach d from `guess`; the history is left as it was.

        Associated flow and penalty contact make the step's energy convex, so the line search
        looks for the length at which the residual is orthogonal to the direction.
        """
        self.md.set_variable("d", [d])
        u = guess.copy()
        r, force = self.residual(u, "build_all")
        for _ in range(60):
            norm = np.linalg.norm(r)
            if norm < 1e-9 * max(force, 1e-2):
                return u, force
            self.iterations += 1
            K = self._csc(self.md.tangent_matrix(), len(u)) + self.exterior
            factor = self._factor(K[self.free][:, self.free])
            grip = self._contact(2).mult(self.lift).ravel()  # derivative of the contact force
            x, y = factor.solve(np.column_stack((-r, self.pull[self.free]))).T
            c = grip[self.free]
            x -= y * (c @ x) / (1 + c @ y)
            full = u.copy()
            full[self.free] += x
            r_full, force = self.residual(full, "build_all")
            slope, slope_full = r @ x, r_full @ x
            if slope_full < 0.5 * abs(slope) or np.linalg.norm(r_full) < 0.5 * norm:
                u, r = full, r_full
            else:
                u[self.free] += self._length(u, x, slope, slope_full) * x
                r, force = self.residual(u, "build_all")
        raise RuntimeError("Newton did not converge at d = %g, residual %g" % (d, norm))

    def _length(self, u, x, slope, s_high):
        """Regula falsi (Illinois) for the zero of the energy's slope along x, loosely."""
        low, s_low, high = 0.0, slope, 1.0
        for _ in range(12):
            t = low - s_low * (high - low) / (s_high - s_low)
            t = min(max(t, low + 0.02 * (high - low)), high - 0.02 * (high - low))
            trial = u.copy()
            trial[self.free] += t * x
            s = self.residual(trial, "build_rhs")[0] @ x
            if abs(s) < 0.3 * abs(slope):
                break
            if s > 0:
                high, s_high, s_low = t, s, 0.5 * s_low
            else:
                low, s_low, s_high = t, s, 0.5 * s_high
        return t

    def commit(self, u, force):
        self.md.set_variable("u", u)
        q = self.md.interpolation("[f;q-G*dg;X(1);X(2)]", self.points).reshape(-1, 4).T
        flow = q[0] > 0
        self.apex += int(np.count_nonzero(flow & (q[1] < 0)))
        if flow.any():
            reach = max(q[2][flow].max(), -q[3][flow].min())
            self.reach = max(self.reach, reach)
            if reach > 0.9 * self.opt["box"]:
                raise RuntimeError("plastic zone reaches %g b; enlarge the box" % reach)
        self.md.set_variable("ep", self.md.interpolation(self.new_ep, self.points))
        self.u, self.force, self.d = u, force, float(self.md.variable("d"))

    def load(self, d, earlier, limit=np.inf):
        """A step to d, extrapolated from the state `earlier` = (d, u); kept if F < limit."""
        guess = self.u
        if earlier is not None:
            guess = self.u + (self.u - earlier[1]) * (d - self.d) / (self.d - earlier[0])
        u, force = self.solve(d, guess)
        if force < limit:
            self.commit(u, force)
        return force < limit

    def unload(self, d):
        """One committed step back to d, predicted elastically with the contact as it is."""
        k = float(self.md.variable("k"))
        self.md.set_variable("k", [k * (1 + 1e-6)])  # states on the cone count as elastic
        self.residual(self.u, "build_all")
        self.md.set_variable("k", [k])
        K = self._csc(self.md.tangent_matrix(), len(self.u)) + self.exterior
        full = self._contact(2).mult(self.lift).ravel()
        grip = full[self.free]
        x, y = self._factor(K[self.free][:, self.free]).solve(
            np.column_stack((-grip * (d - self.d), self.pull[self.free]))).T
        x -= y * (grip @ x + full @ self.lift * (d - self.d)) / (1 + grip @ y)
        guess = self.u.copy()
        guess[self.free] += x
        self.commit(*self.solve(d, guess))

    def contact_edge(self):
        """Midway between the last touching and the first free point; the largest pressure."""
        data = gf.MeshImData(self.mim_top, TOP, [2])
        r, p = self.md.interpolation("[X(1);pen*pos_part(over)]", data, TOP).reshape(-1, 2).T
        last = r[p > 0].max()
        return float((last + r[r > last].min()) / 2), float(p.max())

    def residual_approach(self):
        """Lowest d at which the rigid parabola touches the released surface."""
        top = np.where((self.x[1] > -1e-9) & (np.arange(len(self.u)) % 2 == 1))[0]
        top = top[np.argsort(self.x[0, top])]
        r, u = self.x[0, top], self.u[top]
        s = np.linspace(-1, 1, 21)
        shape = np.array([s * (s - 1) / 2, 1 - s * s, s * (s + 1) / 2])
        rr = np.column_stack((r[:-2:2], r[1::2], r[2::2])) @ shape
        uu = np.column_stack((u[:-2:2], u[1::2], u[2::2])) @ shape
        gap = rr**2 / 2 - uu
        i = np.unravel_index(np.argmin(gap), gap.shape)
        return float(gap[i]), float(rr[i])


def run(material, unit, d_peak, d_rest, **options):
    """One loading-unloading curve; `unit` is b/a_Hertz, d_peak and d_rest only place the steps."""
    began = time.process_time()
    opt = dict(DEFAULTS, **options)
    E, nu, R, F_max = (material[key] for key in ("E", "nu", "R", "F_max"))
    F_y, delta_y = first_yield(**material)
    a_hertz = (0.75 * F_max * R * (1 - nu * nu) / E) ** (1 / 3)
    b = unit * a_hertz
    alpha, k = cone(material["phi"], material["sigma_c"])
    to_force, to_delta = E * b**3 / R / F_y, 2 * b * b / R / delta_y
    target = F_max / F_y / to_force
    body = HalfSpace(nu, alpha, k * R / (E * b), opt)
    N = opt["steps"]
    loading, earlier = [(0.0, 0.0)], None
    for i in range(1, N):
        now = (body.d, body.u)
        if not body.load(d_peak * i / N, earlier, target):
            break
        earlier = now if i > 1 else None
        loading.append((body.d, body.force))
    # secant on d for the last step, F_max to 1e-8
    d0, F0 = loading[-1]
    slope = (F0 - loading[-2][1]) / (d0 - loading[-2][0])
    d = d0 + (target - F0) / slope
    guess = body.u + (body.u - earlier[1]) * (d - d0) / (d0 - earlier[0])
    for _ in range(12):
        guess, F = body.solve(d, guess)
        if abs(F - target) < 1e-8 * target:
            break
        slope = (F - F0) / (d - d0)
        d0, F0, d = d, F, d + (target - F) / slope
    else:
        raise RuntimeError("the peak force was not reached")
    body.commit(guess, F)
    loading.append((d, F))
    radius, pressure = body.contact_edge()
    unloading, M = [(d, F)], opt["release"]
    for j in range(1, M):
        body.unload(d - (d - d_rest) * j / M)
        if body.force == 0.0:
            break
        unloading.append((body.d, body.force))
    body.load(-1.0, None)
    rest, where = body.residual_approach()
    curve = [(rest, 0.0)] + [p for p in unloading[::-1] if p[1] > 0 and p[0] > rest]
    scale = np.array([to_delta, to_force])
    return dict(
        options=options, delta_max=d * to_delta, delta_res=rest * to_delta,
        contact_radius_over_hertz=radius * unit, max_pressure_over_sigma_c=pressure * E * b / R
        / material["sigma_c"], touch_radius_over_contact=where / radius,
        loading=(np.array(loading) * scale).tolist(), unloading=(np.array(curve) * scale).tolist(),
        dofs=len(body.u), elements_across_contact=10 * 2 ** opt["level"] * radius,
        newton_iterations=body.iterations, apex_returns=body.apex,
        plastic_reach_over_contact=body.reach / radius,
        raw=dict(d=d, rest=rest, radius=radius), seconds=time.process_time() - began)
