package rigibo.frontend.puzzle.show;

import rigibo.backend.ContactEvent;
import rigibo.backend.RigidBody;
import rigibo.frontend.puzzle.picture.Skins;
import rigibo.frontend.puzzle.rules.Outcome;
import rigibo.frontend.puzzle.rules.Piece;
import rigibo.frontend.puzzle.rules.PuzzleGame;
import rigibo.frontend.puzzle.rules.Target;
import rigibo.frontend.scene.Deed;
import rigibo.frontend.scene.Impacts;
import rigibo.frontend.scene.Skin;
import rigibo.frontend.scene.Sounds;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;

/** The sounds of a level: impacts and rolling, clicks, the hold, and the end of the game. */
final class Noises {

    /**
     * Number of ticks during a hold, one each half second of the usual 3 s; the last one is the
     * chord.
     */
    private static final int TICKS = 6;

    private final Sounds sounds;
    private final Map<RigidBody, Skin> skins = new IdentityHashMap<>();
    private Impacts impacts;
    private PuzzleGame game;
    private Outcome outcome;
    private int ticks;

    /** Bombs with burning fuses at the last call. */
    private final List<Piece> lit = new ArrayList<>();

    /** Fire doors that were melting at the last call. */
    private final List<Piece> melting = new ArrayList<>();

    /** The sounds of a game from its present state on. */
    Noises(Sounds sounds, PuzzleGame game) {
        this.sounds = sounds;
        listenTo(game);
    }

    /** Takes over the state of another game without sounds: another try, or an undone click. */
    private void listenTo(PuzzleGame other) {
        game = other;
        impacts = new Impacts();
        outcome = other.outcome();
        ticks = ticks(other);
        skins.clear();
        lit.clear();
        melting.clear();
        melting(other).forEach(melting::add);
        other.balls().forEach(ball -> skins.put(ball, Skin.BALL));
        for (Piece piece : other.pieces()) {
            skins.put(piece.body(), Skins.of(piece.substance()));
        }
    }

    private static int ticks(PuzzleGame game) {
        return (int) (TICKS * game.held());
    }

    /** Called when the player's game made a step. */
    void stepped(PuzzleGame played) {
        if (played != game) {
            listenTo(played);
        }
        List<ContactEvent> contacts = game.pool().contactEvents();
        impacts.tell(game.pool(), skins::get, sounds);
        game.balls().stream()
                .filter(ball -> contacts.stream().anyMatch(contact -> carries(contact, ball)))
                .mapToDouble(ball -> Math.abs(ball.angularVelocity()) * rim(ball))
                .max()
                .ifPresent(sounds::roll);
        tellBlasts();
        tellMelting();
        tellHold();
        tellOutcome();
    }

    private void tellBlasts() {
        List<Piece> blown = lit.stream().filter(this::hasBlownUp).toList();
        blown.forEach(bomb -> sounds.did(Deed.BLAST));
        lit.clear();
        game.pieces().stream()
                .filter(piece -> piece.isAlive() && piece.fuse().isPresent())
                .forEach(lit::add);
    }

    private void tellMelting() {
        List<Piece> now = melting(game).toList();
        now.stream().filter(door -> !melting.contains(door)).forEach(door -> sounds.did(Deed.MELT));
        melting.clear();
        melting.addAll(now);
    }

    private static Stream<Piece> melting(PuzzleGame game) {
        return game.pieces().stream().filter(piece -> piece.isAlive() && piece.melt().isPresent());
    }

    /** Whether a bomb blew up; one that fell out of the world did not. */
    private boolean hasBlownUp(Piece bomb) {
        return !bomb.isAlive() && bomb.fuse().orElseThrow().isBurntDown(game.steps());
    }

    private static double rim(RigidBody ball) {
        return ball.shape().boundingRadius();
    }

    private static boolean carries(ContactEvent contact, RigidBody ball) {
        return contact.phase() != ContactEvent.Phase.END
                && (contact.a() == ball || contact.b() == ball);
    }

    private void tellHold() {
        int before = ticks;
        ticks = ticks(game);
        if (ticks > before && ticks < TICKS) {
            sounds.tick(game.held());
        }
    }

    private void tellOutcome() {
        if (game.outcome() != outcome) {
            outcome = game.outcome();
            if (outcome == Outcome.WON) {
                sounds.chord();
            } else {
                sounds.fail();
            }
        }
    }

    /** Called when a click had an effect. */
    void did(Target target) {
        switch (target.verb().orElseThrow()) {
            case DELETE -> sounds.pop();
            case CUT -> sounds.did(Deed.SNIP);
            case PULL -> sounds.did(Deed.PULL);
            case SWITCH -> sounds.did(target.isOn() ? Deed.SWITCH_ON : Deed.SWITCH_OFF);
            case FREEZE -> {
                sounds.did(Deed.FREEZE);
                skins.put(((Piece) target).body(), Skin.STONE);
            }
            case LIGHT -> sounds.did(Deed.FUSE);
        }
    }

    /** Called when a command is not possible at present. */
    void refused() {
        sounds.refuse();
    }
}
