package rigibo.backend.contact.joint;

import java.util.Arrays;

/**
 * The order in which equations are eliminated. Bodies are merged, two assemblies at a time, until
 * each group of joined bodies is one assembly; the equations between two assemblies are eliminated
 * when they merge (R. Featherstone, A divide-and-conquer articulated-body algorithm, 1999). The
 * equations that hold an assembly to others are its border. In each round every assembly is merged
 * with the neighbour that gives the smallest border. Work thus grows linearly for chains and trees,
 * and as n·√n for a net of n bodies, as with nested dissection (George 1973).
 */
final class AssemblyTree {

    static final int NONE = -1;

    private final EquationList equations;

    /** All assemblies, parts before wholes; single bodies come first. */
    int count;

    /** By assembly: the two assemblies that it was merged from, or {@link #NONE} and its body. */
    int[] first = new int[32];

    int[] second = new int[32];

    /**
     * By assembly: the start of its equations, eliminated ones before its border; and the number of
     * eliminated ones.
     */
    int[] start = new int[33];

    int[] own = new int[32];

    /** By place in the lists of assemblies: the equation. */
    int[] equation = new int[256];

    /** Number of groups of joined bodies; and by group the start of its assemblies. */
    int groups;

    int[] groupStart = new int[17];

    /** Bodies group by group; by group the start of its bodies; and by body its group. */
    int[] bodies = new int[16];

    int[] bodyStart = new int[17];
    int[] groupOf = new int[16];

    /**
     * Equations group by group, in the order of elimination; and by group the start of its
     * equations.
     */
    int[] equationOf = new int[64];

    int[] equationStart = new int[17];

    /** Sum of size² over all assemblies, where the size is the number of equations. */
    long room;

    /**
     * By body: the assembly that it is in. By assembly: the one that it was merged into, and the
     * round in which it was made.
     */
    private int[] of = new int[16];

    private int[] whole = new int[32];
    private int[] madeIn = new int[32];

    /** Assemblies that are not merged into another one yet. */
    private int[] alive = new int[16];

    private int aliveCount;

    /** By equation: the number of assemblies that its bodies are in. */
    private int[] spread = new int[64];

    /**
     * By assembly: the number of equations that it shares with the assembly that last looked for a
     * neighbour; and that assembly.
     */
    private int[] shared = new int[32];

    private int[] lookedFrom = new int[32];
    private int[] neighbours = new int[32];
    private int[] takenBy = new int[64];

    AssemblyTree(EquationList equations) {
        this.equations = equations;
    }

    /** Builds the tree of all bodies in the equations. */
    void build() {
        reserve();
        count = 0;
        room = 0;
        for (int e = 0; e < equations.all; e++) {
            spread[e] = equations.bodyEnd(e) - equations.bodyStart(e);
            takenBy[e] = NONE;
        }
        gather();
        for (int group = 0; group < groups; group++) {
            groupStart[group] = count;
            aliveCount = 0;
            for (int i = bodyStart[group]; i < bodyStart[group + 1]; i++) {
                addBody(bodies[i]);
            }
            boolean isAny = true;
            for (int round = 1; isAny; round++) {
                isAny = putTogether(round);
            }
        }
        groupStart[groups] = count;
        listEquations();
    }

    private void listEquations() {
        int end = 0;
        for (int group = 0; group < groups; group++) {
            equationStart[group] = end;
            for (int n = groupStart[group]; n < groupStart[group + 1]; n++) {
                System.arraycopy(equation, start[n], equationOf, end, own[n]);
                end += own[n];
            }
        }
        equationStart[groups] = end;
    }

    /** Finds the groups: all bodies that equations connect. */
    private void gather() {
        groups = 0;
        Arrays.fill(groupOf, 0, equations.bodyCount, NONE);
        int end = 0;
        for (int body = 0; body < equations.bodyCount; body++) {
            if (groupOf[body] == NONE) {
                bodyStart[groups] = end;
                groupOf[body] = groups;
                bodies[end++] = body;
                for (int i = bodyStart[groups]; i < end; i++) {
                    end = reach(bodies[i], end);
                }
                groups++;
            }
        }
        bodyStart[groups] = end;
    }

    private int reach(int body, int from) {
        int end = from;
        for (int i = equations.equationStart(body); i < equations.equationEnd(body); i++) {
            int e = equations.equationOf(i);
            for (int k = equations.bodyStart(e); k < equations.bodyEnd(e); k++) {
                int next = equations.bodyOf(k);
                if (groupOf[next] == NONE) {
                    groupOf[next] = groups;
                    bodies[end++] = next;
                }
            }
        }
        return end;
    }

    private void reserve() {
        int most = 2 * equations.bodyCount + 1;
        if (first.length < most) {
            first = new int[2 * most];
            second = new int[2 * most];
            start = new int[2 * most + 1];
            own = new int[2 * most];
            whole = new int[2 * most];
            madeIn = new int[2 * most];
            shared = new int[2 * most];
            lookedFrom = new int[2 * most];
            neighbours = new int[2 * most];
            of = new int[2 * most];
            alive = new int[2 * most];
            groupStart = new int[2 * most + 1];
            equationStart = new int[2 * most + 1];
            bodies = new int[2 * most];
            bodyStart = new int[2 * most + 1];
            groupOf = new int[2 * most];
        }
        if (spread.length < equations.all) {
            spread = new int[2 * equations.all];
            takenBy = new int[2 * equations.all];
            equationOf = new int[2 * equations.all];
        }
    }

    private void addBody(int body) {
        int assembly = begin(NONE, body, 0);
        of[body] = assembly;
        int from = equations.equationStart(body);
        int to = equations.equationEnd(body);
        room(to - from);
        int at = start[assembly];
        for (int i = from; i < to; i++) {
            int e = equations.equationOf(i);
            if (spread[e] == 1) {
                equation[at++] = e;
            }
        }
        own[assembly] = at - start[assembly];
        for (int i = from; i < to; i++) {
            int e = equations.equationOf(i);
            if (spread[e] > 1) {
                equation[at++] = e;
            }
        }
        end(assembly, at);
    }

    private int begin(int a, int b, int round) {
        int assembly = count++;
        first[assembly] = a;
        second[assembly] = b;
        whole[assembly] = NONE;
        madeIn[assembly] = round;
        lookedFrom[assembly] = NONE;
        if (assembly == 0) {
            start[0] = 0;
        }
        return assembly;
    }

    private void room(int more) {
        int needed = start[count - 1] + more;
        if (equation.length < needed) {
            equation = Arrays.copyOf(equation, 2 * needed);
        }
    }

    private void end(int assembly, int at) {
        start[assembly + 1] = at;
        long size = at - start[assembly];
        room += size * size;
        if (size > own[assembly]) {
            alive[aliveCount++] = assembly;
        }
    }

    /** Number of equations in an assembly's border. */
    int border(int assembly) {
        return start[assembly + 1] - start[assembly] - own[assembly];
    }

    /** The assembly that a body is in at present. */
    private int assemblyOf(int body) {
        int at = of[body];
        while (whole[at] != NONE) {
            at = whole[at];
        }
        of[body] = at;
        return at;
    }

    /** Merges each assembly with at most one other; returns whether any was merged. */
    private boolean putTogether(int round) {
        boolean isAny = false;
        int before = aliveCount;
        aliveCount = 0;
        for (int i = 0; i < before; i++) {
            int assembly = alive[i];
            if (whole[assembly] == NONE && madeIn[assembly] < round) {
                int other = neighbour(assembly, round);
                if (other == NONE) {
                    alive[aliveCount++] = assembly;
                } else {
                    // Only entries up to i are overwritten, and these have been read.
                    unite(assembly, other, round);
                    isAny = true;
                }
            }
        }
        return isAny;
    }

    /** The neighbour that gives the smallest border, among those not merged in this round. */
    private int neighbour(int assembly, int round) {
        int found = 0;
        for (int i = start[assembly] + own[assembly]; i < start[assembly + 1]; i++) {
            int e = equation[i];
            for (int k = equations.bodyStart(e); k < equations.bodyEnd(e); k++) {
                int other = assemblyOf(equations.bodyOf(k));
                if (other != assembly && madeIn[other] < round) {
                    if (lookedFrom[other] != assembly) {
                        lookedFrom[other] = assembly;
                        shared[other] = 0;
                        neighbours[found++] = other;
                    }
                    shared[other]++;
                }
            }
        }
        int best = NONE;
        int least = Integer.MAX_VALUE;
        for (int i = 0; i < found; i++) {
            int left = border(neighbours[i]) - 2 * shared[neighbours[i]];
            if (left < least) {
                least = left;
                best = neighbours[i];
            }
        }
        return best;
    }

    private void unite(int a, int b, int round) {
        int made = begin(a, b, round);
        whole[a] = made;
        whole[b] = made;
        room(border(a) + border(b));
        int at = start[made];
        // Equations in both borders: each is now in one assembly fewer.
        for (int i = start[a] + own[a]; i < start[a + 1]; i++) {
            takenBy[equation[i]] = made;
        }
        for (int i = start[b] + own[b]; i < start[b + 1]; i++) {
            int e = equation[i];
            if (takenBy[e] == made && --spread[e] == 1) {
                equation[at++] = e;
            }
        }
        own[made] = at - start[made];
        at = addBorder(a, at, made, false);
        at = addBorder(b, at, made, true);
        end(made, at);
    }

    private int addBorder(int part, int from, int made, boolean isSecond) {
        int at = from;
        for (int i = start[part] + own[part]; i < start[part + 1]; i++) {
            int e = equation[i];
            boolean isListed = isSecond && takenBy[e] == made;
            if (spread[e] > 1 && !isListed) {
                equation[at++] = e;
            }
        }
        return at;
    }
}
