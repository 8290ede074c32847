package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;

import java.util.Arrays;

/**
 * K = J·M⁻¹·Jᵀ of all equations of an island, with their compliances on its diagonal, factored
 * along an {@link AssemblyTree}. A body contributes the responses of its equations through it; two
 * assemblies that merge add theirs up, and the equations between them are eliminated (I. Duff and
 * J. Reid, The multifrontal solution of indefinite sparse symmetric linear equations, 1983).
 */
final class EquationFactor {

    private final Motions motions;
    private final NeutralRows rows;
    private final EquationList equations;
    private final AssemblyTree tree;

    /**
     * By assembly, from {@link #at} on, the upper triangle of a square: for eliminated equations
     * the rows D·Lᵀ with 1/D on the diagonal, for the border its responses.
     */
    private double[] square = new double[1024];

    private int[] at = new int[32];

    /** By equation: its place in the assembly being merged. */
    private int[] place = new int[64];

    /** By place: the derivatives of a body's equations. */
    private double[] alongX = new double[32];

    private double[] alongY = new double[32];
    private double[] turning = new double[32];

    /** By equation: the change of speed that is asked for, later the impulse. */
    private double[] unknown = new double[64];

    /** The equations that were factored last; only those that changed are factored again. */
    private final FactoredRows factored;

    /** By group: whether its factor is that of the equations that hold. */
    private boolean[] isReady = new boolean[16];

    /** Number of multiplications since the last call. */
    private double work;

    EquationFactor(Motions motions, NeutralRows rows) {
        this.motions = motions;
        this.rows = rows;
        equations = new EquationList(motions, rows);
        tree = new AssemblyTree(equations);
        factored = new FactoredRows(motions, rows, equations, tree);
    }

    /** Number of multiplications since the last call. */
    double takeWork() {
        double sum = work;
        work = 0;
        return sum;
    }

    /** The order in which equations are eliminated. */
    AssemblyTree tree() {
        return tree;
    }

    /** The factored equations; those with bounds may be exchanged. */
    EquationList equations() {
        return equations;
    }

    /** Lists the equations of the present rows; no row with bounds holds. */
    void layOut() {
        if (equations.list()) {
            tree.build();
            reserve();
            factored.forget();
        }
    }

    /**
     * Discards all factors at the start of another island or step, whose results may not depend on
     * them.
     */
    void forget() {
        factored.forget();
    }

    /** Notes that other equations hold in a group. */
    void change(int group) {
        isReady[group] = false;
    }

    /**
     * Notes that rows were written anew, or that other equations hold, in all groups. A group is
     * factored when it is next solved, and only if it differs from the factored one.
     */
    void changeAll() {
        Arrays.fill(isReady, 0, tree.groups, false);
    }

    private void makeReady(int group) {
        if (isReady[group]) {
            return;
        }
        if (factored.change(group) > FactoredRows.SAME) {
            factorize(group);
        }
        isReady[group] = true;
    }

    private void factorize(int group) {
        for (int n = tree.groupStart[group]; n < tree.groupStart[group + 1]; n++) {
            int from = at[n];
            int size = tree.start[n + 1] - tree.start[n];
            if (tree.first[n] == AssemblyTree.NONE) {
                assembleBody(n, size);
            } else {
                Arrays.fill(square, from, from + size * size, 0);
                for (int i = 0; i < size; i++) {
                    place[tree.equation[tree.start[n] + i]] = i;
                }
                add(tree.first[n], from, size);
                add(tree.second[n], from, size);
            }
            eliminate(n, size);
        }
        factored.keep(group);
    }

    private void reserve() {
        if (square.length < tree.room) {
            square = new double[(int) (2 * tree.room)];
        }
        if (at.length < tree.count) {
            at = new int[2 * tree.count];
        }
        if (isReady.length < tree.groups) {
            isReady = new boolean[2 * tree.groups];
        }
        int from = 0;
        for (int n = 0; n < tree.count; n++) {
            at[n] = from;
            int size = tree.start[n + 1] - tree.start[n];
            from += size * size;
        }
        if (place.length < equations.all) {
            place = new int[2 * equations.all];
            unknown = new double[2 * equations.all];
            alongX = new double[2 * equations.all];
            alongY = new double[2 * equations.all];
            turning = new double[2 * equations.all];
        }
    }

    /** Writes the responses of a body's equations through that body. */
    private void assembleBody(int n, int size) {
        int body = tree.second[n];
        int entry = equations.entry[body];
        int copies = equations.copiesOf(body);
        double mass = copies * motions.data[entry * Motions.STRIDE + Motions.INVERSE_MASS];
        double inertia = copies * motions.data[entry * Motions.STRIDE + Motions.INVERSE_INERTIA];
        for (int i = 0; i < size; i++) {
            int e = tree.equation[tree.start[n] + i];
            if (equations.isWeld(e)) {
                deriveWeld(i, e, body);
            } else {
                derive(i, equations.row[e], entry);
            }
        }
        for (int i = 0; i < size; i++) {
            double x = mass * alongX[i];
            double y = mass * alongY[i];
            double turn = inertia * turning[i];
            int to = at[n] + i * size;
            for (int j = i; j < size; j++) {
                square[to + j] = x * alongX[j] + y * alongY[j] + turn * turning[j];
            }
        }
    }

    private void deriveWeld(int i, int e, int body) {
        double side = equations.bodyOf(equations.bodyStart(e)) == body ? -1 : 1;
        int along = equations.weldedAlong(e);
        alongX[i] = along == 0 ? side : 0;
        alongY[i] = along == 1 ? side : 0;
        turning[i] = along == 2 ? side : 0;
    }

    private void derive(int i, int row, int entry) {
        alongX[i] = 0;
        alongY[i] = 0;
        turning[i] = 0;
        int bodies = row == EquationList.NONE ? 0 : rows.bodies[row];
        for (int k = 0; k < bodies; k++) {
            if (rows.body[row * NeutralRows.BODIES + k] == entry * Motions.STRIDE) {
                int from = row * NeutralRows.DERIVATIVES + 3 * k;
                alongX[i] += rows.derivative[from];
                alongY[i] += rows.derivative[from + 1];
                turning[i] += rows.derivative[from + 2];
            }
        }
    }

    /** Adds the responses of a part's border to the square of the whole. */
    private void add(int part, int to, int wide) {
        int size = tree.start[part + 1] - tree.start[part];
        int[] equation = tree.equation;
        for (int i = tree.own[part]; i < size; i++) {
            int line = place[equation[tree.start[part] + i]];
            int from = at[part] + i * size;
            for (int j = i; j < size; j++) {
                int column = place[equation[tree.start[part] + j]];
                int target = line < column ? line * wide + column : column * wide + line;
                square[to + target] += square[from + j];
            }
        }
    }

    private void eliminate(int n, int size) {
        int own = tree.own[n];
        int from = at[n];
        double[] s = square;
        for (int k = 0; k < own; k++) {
            int pivotLine = from + k * size;
            double inverse = inverse(tree.equation[tree.start[n] + k], s[pivotLine + k]);
            s[pivotLine + k] = inverse;
            if (inverse == 0) {
                continue;
            }
            for (int i = k + 1; i < size; i++) {
                double factor = s[pivotLine + i] * inverse;
                if (factor != 0) {
                    subtract(s, from + i * size + i, pivotLine + i, factor, size - i);
                }
            }
            work += (size - k) * (size - k) / 2.0;
        }
    }

    /** 1/D of an equation from its pivot without compliance; 0 if no row holds in its place. */
    private double inverse(int e, double without) {
        int row = equations.row[e];
        if (row == EquationList.NONE) {
            // Copies of a body of unlimited mass or inertia need no weld.
            return equations.isWeld(e) && without > 0 ? 1 / without : 0;
        }
        double pivot = without + NeutralRows.REGULAR * rows.response[row] + rows.give[row];
        return 1 / rows.pivot(row, pivot);
    }

    /** Subtracts a multiple of one line from another. */
    private static void subtract(double[] s, int to, int from, double factor, int length) {
        for (int j = 0; j < length; j++) {
            s[to + j] -= factor * s[from + j];
        }
    }

    /** Asks for a change of an equation's speed, m/s. */
    void ask(int equation, double change) {
        unknown[equation] = change;
    }

    /** The impulse of an equation in the solution. */
    double answer(int equation) {
        return unknown[equation];
    }

    /** Solves for the impulses of a group that give all changes asked for. */
    void solve(int group) {
        makeReady(group);
        double[] x = unknown;
        int[] equation = tree.equation;
        int from = tree.groupStart[group];
        int to = tree.groupStart[group + 1];
        for (int n = from; n < to; n++) {
            int start = tree.start[n];
            int size = tree.start[n + 1] - start;
            for (int k = 0; k < tree.own[n]; k++) {
                int line = at[n] + k * size;
                double share = x[equation[start + k]] * square[line + k];
                if (share != 0) {
                    for (int j = k + 1; j < size; j++) {
                        x[equation[start + j]] -= square[line + j] * share;
                    }
                    work += size - k;
                }
            }
        }
        for (int n = to - 1; n >= from; n--) {
            int start = tree.start[n];
            int size = tree.start[n + 1] - start;
            for (int k = tree.own[n] - 1; k >= 0; k--) {
                int line = at[n] + k * size;
                double sum = x[equation[start + k]];
                for (int j = k + 1; j < size; j++) {
                    sum -= square[line + j] * x[equation[start + j]];
                }
                x[equation[start + k]] = sum * square[line + k];
            }
            work += (double) size * tree.own[n];
        }
    }
}
