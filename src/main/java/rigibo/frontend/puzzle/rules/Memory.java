package rigibo.frontend.puzzle.rules;

import rigibo.frontend.puzzle.level.Limits;
import rigibo.frontend.puzzle.level.Steps;

import java.util.ArrayList;
import java.util.List;

/**
 * What the rules remember of a game besides its bodies.
 *
 * @param steps done
 * @param cooldown since the last click
 * @param hold of the balls on the platform
 * @param rest of everything
 * @param trace of its states
 * @param acts the clicks that did something
 */
record Memory(
        int steps, Cooldown cooldown, HoldClock hold, RestWatch rest, Trace trace, List<Act> acts) {

    static Memory atTheStart(Limits limits) {
        return new Memory(
                0,
                new Cooldown(Steps.of(limits.cooldown())),
                new HoldClock(Steps.of(limits.hold()), Steps.of(limits.contactGrace())),
                new RestWatch(),
                new Trace(),
                new ArrayList<>());
    }

    Memory copy() {
        return new Memory(
                steps,
                cooldown.copy(),
                hold.copy(),
                rest.copy(),
                trace.copy(),
                new ArrayList<>(acts));
    }
}
