package rigibo;

import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.HelpCommand;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

import java.io.PrintWriter;

/** The command line, with a subcommand for each thing that can be started. */
@Command(
        name = "rigibo",
        description = "A desktop physics puzzle on an engine of its own.",
        subcommands = {
            PlayCommand.class,
            TourCommand.class,
            MeasureCommand.class,
            MonkeyCommand.class,
            FuzzCommand.class,
            LevelsCommand.class,
            ReplayCommand.class,
            RecordCommand.class,
            CasesCommand.class,
            LabCommand.class,
            BenchCommand.class,
            HelpCommand.class
        })
public final class Main implements Runnable {
    @Spec private CommandSpec spec;

    /**
     * Runs the command and ends the process with its exit code: 0 for success, 1 for failure, 2 for
     * a command that was not understood.
     */
    public static void main(String[] arguments) {
        System.exit(
                run(
                        new PrintWriter(System.out, true),
                        new PrintWriter(System.err, true),
                        arguments));
    }

    /** Runs the command, printing to {@code out} and {@code err}; returns the exit code. */
    static int run(PrintWriter out, PrintWriter err, String... arguments) {
        CommandLine rigibo = new CommandLine(new Main());
        addHelp(rigibo);
        return rigibo.setCaseInsensitiveEnumValuesAllowed(true)
                .setOut(out)
                .setErr(err)
                .execute(arguments);
    }

    /** Adds {@code --help} to a command and its subcommands, except "help", which has it. */
    private static void addHelp(CommandLine command) {
        if (!(command.getCommand() instanceof HelpCommand)) {
            command.getCommandSpec()
                    .addOption(
                            OptionSpec.builder("-h", "--help")
                                    .usageHelp(true)
                                    .description("Prints this.")
                                    .build());
        }
        command.getSubcommands().values().forEach(Main::addHelp);
    }

    /** Refuses a call without a command, and lists the commands. */
    @Override
    public void run() {
        throw new ParameterException(spec.commandLine(), "Which command?");
    }
}
