package rigibo.lab.precision;

import tools.jackson.databind.json.JsonMapper;

import java.util.LinkedHashMap;
import java.util.Map;

/**
 * The environment in which the numbers of a report were measured.
 *
 * @param machine its processors and system
 * @param jvm name and version of the virtual machine
 * @param flags the virtual machine's flags
 * @param commit of the engine that was measured
 * @param date of the measurement
 * @param command that repeats the report
 */
public record Environment(
        String machine, String jvm, String flags, String commit, String date, String command) {

    /** A copy with other flags, for processes that were started with them. */
    public Environment withFlags(String others) {
        return new Environment(machine, jvm, others, commit, date, command);
    }

    /** All fields, for programs. */
    String json() {
        Map<String, String> fields = new LinkedHashMap<>();
        fields.put("processor", machine);
        fields.put("jvm", jvm);
        fields.put("flags", flags);
        fields.put("commit", commit);
        fields.put("date", date);
        fields.put("command", command);
        return JsonMapper.shared().writerWithDefaultPrettyPrinter().writeValueAsString(fields);
    }

    /** One sentence about all but the command. */
    public String words() {
        return String.format(
                "Measured on %s, on %s, with %s (%s), at commit %s.",
                date, machine, jvm, flags, commit);
    }

    /** Two sentences about all of it, in Markdown. */
    public String provenance() {
        return words() + " By `" + command + "`.";
    }
}
