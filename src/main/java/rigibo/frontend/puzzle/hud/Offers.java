package rigibo.frontend.puzzle.hud;

import rigibo.frontend.puzzle.session.Pace;
import rigibo.frontend.puzzle.session.Session;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/** Which commands have buttons below the play, and which of these buttons are lit. */
final class Offers {

    private final Session session;
    private final List<Command> exits;

    /** The commands of a session that can be left by {@code exits}. */
    Offers(Session session, List<Command> exits) {
        this.session = session;
        this.exits = exits;
    }

    /** The commands of a desktop window in their order, with those available at present. */
    List<Command> onADesk(Set<Command> atTimes) {
        if (session.isShowing()) {
            return List.of(Command.PAUSE, Command.SLOWER, Command.STOP);
        }
        List<Command> commands = new ArrayList<>(List.of(Command.RESTART, Command.UNDO));
        if (session.game().isSolved()) {
            commands.add(Command.COPY);
        } else {
            commands.add(Command.PAUSE);
            commands.add(Command.SLOWER);
        }
        commands.add(Command.EFFECTS);
        commands.addAll(atTimes);
        commands.add(exits.get(exits.size() - 1));
        return commands;
    }

    /** The commands of a handheld window. They hold all ways out, since fingers have no Esc key. */
    List<Command> inAHand(Set<Command> atTimes) {
        if (session.isShowing()) {
            return List.of(Command.PAUSE, Command.SLOWER, Command.STOP);
        }
        List<Command> commands = new ArrayList<>(List.of(Command.RESTART, Command.UNDO));
        commands.add(
                session.game().isSolved()
                        ? Command.COPY
                        : session.isPaused() ? Command.RESUME : Command.PAUSE);
        if (!session.game().isSolved()) {
            commands.add(Command.SLOWER);
        }
        commands.addAll(atTimes);
        commands.addAll(exits);
        return commands;
    }

    /** The commands in effect now, such as an open drawer. */
    List<Command> lit(Panels.Drawer open) {
        List<Command> lit = new ArrayList<>();
        if (session.isPaused()) {
            lit.add(Command.PAUSE);
            lit.add(Command.RESUME);
        }
        if (session.pace() != Pace.FULL) {
            lit.add(Command.SLOWER);
        }
        if (open == Panels.Drawer.EFFECTS) {
            lit.add(Command.EFFECTS);
        }
        if (session.hasGhost()) {
            lit.add(Command.GHOST);
        }
        if (open == Panels.Drawer.HINT) {
            lit.add(Command.HINT);
        }
        return lit;
    }
}
