package rigibo.frontend.save;

import rigibo.frontend.scene.Settings;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;

/** A game in a process of its own, on a home shared with others; a test tells it what to do. */
final class OtherGame implements AutoCloseable {

    private final Process process;
    private final PrintStream to;
    private final BufferedReader from;

    private OtherGame(Process process) {
        this.process = process;
        to = new PrintStream(process.getOutputStream(), true, StandardCharsets.UTF_8);
        from =
                new BufferedReader(
                        new InputStreamReader(process.getInputStream(), StandardCharsets.UTF_8));
    }

    static OtherGame on(Path home) throws IOException {
        String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
        String classes = System.getProperty("java.class.path");
        ProcessBuilder builder =
                new ProcessBuilder(
                        java, "-XX:+UseSerialGC", "-cp", classes, OtherGame.class.getName());
        builder.command().add(home.toString());
        OtherGame game =
                new OtherGame(builder.redirectError(ProcessBuilder.Redirect.INHERIT).start());
        game.done();
        return game;
    }

    /**
     * Tells it to do something: {@code solve LEVEL}, {@code volume V}, {@code begin FILE}, {@code
     * hold}.
     */
    void tell(String what) {
        to.println(what);
    }

    /** Waits until the other game has followed an order, and returns its answer. */
    String done() throws IOException {
        return from.readLine();
    }

    long pid() {
        return process.pid();
    }

    /** Ends it without giving it a chance, as {@code kill -9} does. */
    @Override
    public void close() {
        process.destroyForcibly().onExit().join();
    }

    /** Holds the lock until the next line comes. */
    private static void hold(Path home, BufferedReader lines) throws IOException {
        new FolderLock(home, Duration.ZERO)
                .during(
                        () -> {
                            System.out.println("held");
                            lines.readLine();
                        });
    }

    /** Does what its standard input says, a line each, and answers with a line. */
    public static void main(String[] arguments) throws IOException {
        Path home = Path.of(arguments[0]);
        SavedPlayer player = new SavedPlayer(Places.in(home), "en");
        BufferedReader lines = new BufferedReader(new InputStreamReader(System.in));
        System.out.println("ready");
        for (String line = lines.readLine(); line != null; line = lines.readLine()) {
            String[] words = line.split(" ");
            switch (words[0]) {
                case "solve" -> player.progress(player.progress().solved(words[1], 1, 1));
                case "volume" -> {
                    Settings chosen = player.settings();
                    player.settings(chosen.withVolume(Double.parseDouble(words[1])));
                }
                case "begin" -> new SafeFile(home.resolve(words[1])).prepare(new byte[1]);
                case "hold" -> hold(home, lines);
                default -> throw new IllegalArgumentException(line);
            }
            player.save();
            System.out.println("done");
        }
    }
}
