package rigibo.backend.contact.joint;

import rigibo.backend.contact.row.Motions;

import java.util.Arrays;

/**
 * The equations that were factored last, by groups of joined bodies. Groups at rest keep their
 * factors from kick to kick of a step. The next step begins anew, so that its result does not
 * depend on earlier ones.
 */
final class FactoredRows {

    /**
     * Largest change of an equation for which its factor is kept: the response to an impulse along
     * the change, as a share of the response to one along the equation.
     */
    static final double SAME = 1e-6;

    private final Motions motions;
    private final NeutralRows rows;
    private final EquationList equations;
    private final AssemblyTree tree;

    /** By equation: its row or none, its compliance, and its derivatives. */
    private int[] row = new int[64];

    private double[] give = new double[64];
    private double[] derivative = new double[64 * NeutralRows.DERIVATIVES];

    /** By group: whether it is kept. */
    private boolean[] isKept = new boolean[16];

    FactoredRows(Motions motions, NeutralRows rows, EquationList equations, AssemblyTree tree) {
        this.motions = motions;
        this.rows = rows;
        this.equations = equations;
        this.tree = tree;
    }

    /** Discards all groups. */
    void forget() {
        Arrays.fill(isKept, false);
    }

    /** Keeps a group in its present state. */
    void keep(int group) {
        reserve();
        isKept[group] = true;
        for (int n = tree.groupStart[group]; n < tree.groupStart[group + 1]; n++) {
            for (int i = tree.start[n]; i < tree.start[n] + tree.own[n]; i++) {
                keepEquation(tree.equation[i]);
            }
        }
    }

    private void reserve() {
        if (row.length < equations.all) {
            int capacity = 2 * equations.all;
            row = Arrays.copyOf(row, capacity);
            give = Arrays.copyOf(give, capacity);
            derivative = Arrays.copyOf(derivative, capacity * NeutralRows.DERIVATIVES);
        }
        if (isKept.length < tree.groups) {
            isKept = Arrays.copyOf(isKept, 2 * tree.groups);
        }
    }

    private void keepEquation(int e) {
        row[e] = equations.row[e];
        if (row[e] != EquationList.NONE) {
            give[e] = rows.give[row[e]];
            int length = 3 * rows.bodies[row[e]];
            int from = row[e] * NeutralRows.DERIVATIVES;
            System.arraycopy(
                    rows.derivative, from, derivative, e * NeutralRows.DERIVATIVES, length);
        }
    }

    /**
     * The largest change of a group's equations since it was kept, as a share of their responses.
     */
    double change(int group) {
        if (group >= isKept.length || !isKept[group]) {
            return Double.POSITIVE_INFINITY;
        }
        double most = 0;
        for (int n = tree.groupStart[group]; n < tree.groupStart[group + 1]; n++) {
            for (int i = tree.start[n]; i < tree.start[n] + tree.own[n]; i++) {
                most = Math.max(most, changeOf(tree.equation[i]));
            }
        }
        return most;
    }

    private double changeOf(int e) {
        int now = equations.row[e];
        if (now != row[e]) {
            return Double.POSITIVE_INFINITY;
        }
        if (now == EquationList.NONE) {
            return 0;
        }
        double response = rows.response[now];
        double given = 0;
        for (int k = 0; k < rows.bodies[now]; k++) {
            int offset = rows.body[now * NeutralRows.BODIES + k];
            double mass = motions.data[offset + Motions.INVERSE_MASS];
            double inertia = motions.data[offset + Motions.INVERSE_INERTIA];
            double x = change(e, now, 3 * k);
            double y = change(e, now, 3 * k + 1);
            double turn = change(e, now, 3 * k + 2);
            given += mass * (x * x + y * y) + inertia * turn * turn;
        }
        return Math.max(Math.sqrt(given / response), Math.abs(rows.give[now] - give[e]) / response);
    }

    private double change(int e, int now, int k) {
        return rows.derivative[now * NeutralRows.DERIVATIVES + k]
                - derivative[e * NeutralRows.DERIVATIVES + k];
    }
}
