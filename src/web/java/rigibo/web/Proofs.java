package rigibo.web;

import rigibo.frontend.document.Problem;
import rigibo.frontend.puzzle.check.LevelProof;
import rigibo.frontend.puzzle.generate.Generated;
import rigibo.frontend.puzzle.generate.Generator;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;

/**
 * Prints the level of a seed, the effort of finding it, and the problems that a proof finds in a
 * draft.
 */
final class Proofs {

    /** A seed whose level takes few games. */
    private static final long SEED = 20_261_132;

    private Proofs() {}

    static void print() {
        List<Integer> order = new ArrayList<>(IntStream.range(0, 20).boxed().toList());
        Collections.shuffle(order, new Random(SEED));
        System.out.println(Bits.MARK + "the order of a sample: " + order);
        Generated made = new Generator().first(List.of(SEED)).orElseThrow();
        System.out.println(
                Bits.MARK + "level " + SEED + ": " + Long.toHexString(made.level().hash()));
        System.out.println(Bits.MARK + "its figures: " + made.figures() + "; " + made.effort());
        String tooLong = made.text().replaceFirst("\"par\"\\s*:\\s*3", "\"par\": 4");
        List<Problem> problems = LevelProof.problems("draft", tooLong, games -> {});
        System.out.println(Bits.MARK + "draft of par 4: " + problems.size() + " " + problems);
    }
}
