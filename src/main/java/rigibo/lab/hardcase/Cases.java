package rigibo.lab.hardcase;

import java.io.PrintStream;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;

/** Runs hard cases by hand and prints every figure: {@code --only 20/10,49 --preset GAME}. */
public final class Cases {

    private final PrintStream out;
    private int passed;
    private int failed;

    Cases(PrintStream out) {
        this.out = out;
    }

    /**
     * Runs the cases that the arguments choose, all at GAME without any.
     *
     * @param arguments {@code --only ROW,…} (a row before the slash means all its parts), {@code
     *     --preset NAME,…}
     */
    public static void main(String... arguments) {
        Cases cases = new Cases(System.out);
        List<Preset> presets = new ArrayList<>();
        for (String name : after("--preset", "GAME", arguments)) {
            presets.add(Preset.valueOf(name.toUpperCase(Locale.ROOT)));
        }
        cases.run(after("--only", "", arguments), presets);
        System.out.println(cases.passed + " passed, " + cases.failed + " failed");
        if (cases.failed > 0) {
            System.exit(1);
        }
    }

    void run(List<String> rows, List<Preset> presets) {
        for (HardCase hardCase : HardCases.all()) {
            for (Preset preset : presets) {
                boolean isHeld = preset.compareTo(hardCase.fastest()) >= 0;
                if (isHeld && isChosen(hardCase.row(), rows)) {
                    run(hardCase, preset);
                }
            }
        }
    }

    private void run(HardCase hardCase, Preset preset) {
        boolean passes = false;
        try {
            HardCase.Result result = hardCase.run(preset);
            out.println(result);
            passes = result.passes();
        } catch (RuntimeException | AssertionError broken) {
            // One broken case must not hide what the others measure.
            out.println(hardCase.row() + " " + preset + ": FAIL " + broken);
            broken.printStackTrace(out);
        }
        passed += passes ? 1 : 0;
        failed += passes ? 0 : 1;
    }

    private static boolean isChosen(String row, List<String> rows) {
        return rows.contains("") || rows.contains(row) || rows.contains(row.split("/")[0]);
    }

    private static List<String> after(String option, String otherwise, String... arguments) {
        int at = Arrays.asList(arguments).indexOf(option);
        String value = at >= 0 && at + 1 < arguments.length ? arguments[at + 1] : otherwise;
        return Arrays.asList(value.split(","));
    }
}
