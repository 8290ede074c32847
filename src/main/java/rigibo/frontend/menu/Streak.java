package rigibo.frontend.menu;

import java.time.LocalDate;
import java.util.SortedSet;

/**
 * Days in a row whose levels were solved.
 *
 * @param present days up to today; today itself may still be missing
 * @param longest days that ever were
 */
record Streak(int present, int longest) {

    /**
     * The streaks among some days.
     *
     * @param days whose level was solved
     * @param today the day that runs
     */
    static Streak of(SortedSet<LocalDate> days, LocalDate today) {
        int longest = 0;
        int run = 0;
        LocalDate last = LocalDate.MIN;
        for (LocalDate day : days) {
            run = day.minusDays(1).equals(last) ? run + 1 : 1;
            longest = Math.max(longest, run);
            last = day;
        }
        boolean goesOn = last.equals(today) || last.equals(today.minusDays(1));
        return new Streak(goesOn ? run : 0, longest);
    }
}
