package rigibo.lab.hardcase;

import java.util.ArrayList;
import java.util.List;

/** A list of cases in the order of the report. */
final class CaseList {

    private final List<HardCase> cases = new ArrayList<>();

    /** Adds a case that is counted, and held to its limits, at every preset. */
    CaseList add(String row, String title, Scenes scenes) {
        return add(HardCase.of(row, title, scenes));
    }

    /** Adds a case whose own figures have limits from GAME on. */
    CaseList fromGame(String row, String title, Scenes scenes) {
        return add(HardCase.of(row, title, scenes).limitedFrom(Preset.GAME));
    }

    /** Adds a case of impacts, which DRAFT leaves to the single solve of a pile in a step. */
    CaseList ofImpacts(String row, String title, Scenes scenes) {
        return fromGame(row, title, scenes);
    }

    /** Adds a case of a force that varies along the path, which DRAFT evaluates once a step. */
    CaseList ofFields(String row, String title, Scenes scenes) {
        return fromGame(row, title, scenes);
    }

    /** Adds a case of bodies that turn on a corner, too coarse for DRAFT's single substep. */
    CaseList ofCorners(String row, String title, Scenes scenes) {
        return fromGame(row, title, scenes);
    }

    private CaseList add(HardCase one) {
        cases.add(one);
        return this;
    }

    /** States why the last case added does not reach its truth everywhere. */
    CaseList finding(String words) {
        int last = cases.size() - 1;
        cases.set(last, cases.get(last).finding(words));
        return this;
    }

    /** Sets the fastest preset of the last case added. */
    CaseList fastest(Preset preset) {
        int last = cases.size() - 1;
        cases.set(last, cases.get(last).fastest(preset));
        return this;
    }

    List<HardCase> all() {
        return List.copyOf(cases);
    }
}
