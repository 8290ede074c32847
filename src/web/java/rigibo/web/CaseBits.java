package rigibo.web;

import rigibo.lab.hardcase.HardCase;
import rigibo.lab.hardcase.HardCases;
import rigibo.lab.hardcase.Preset;

/** Prints a hash of the states of each hard case at GAME. */
public final class CaseBits {

    private CaseBits() {}

    /** Runs in a browser. */
    public static void main(String[] arguments) {
        print();
    }

    /** Prints all lines. */
    public static void print() {
        HardCases.all().stream()
                .filter(hardCase -> Preset.GAME.compareTo(hardCase.fastest()) >= 0)
                .forEach(hardCase -> System.out.println(line(hardCase)));
    }

    private static String line(HardCase hardCase) {
        return Bits.MARK + "case " + hardCase.row() + ": " + outcome(hardCase);
    }

    /** The result of a case; a broken one must not hide those of the others. */
    private static String outcome(HardCase hardCase) {
        try {
            return Long.toHexString(hardCase.states(Preset.GAME));
        } catch (RuntimeException broken) {
            return "broken by " + broken;
        }
    }
}
