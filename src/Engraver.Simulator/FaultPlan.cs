using System.Text.Json;

namespace Engraver.Simulator;

/// <summary>Faults to inject (galil-dmc.md I.15). Commands are counted from 1 over all handles unless a fault names a handle.</summary>
public sealed record FaultPlan
{
    /// <summary>Commands to answer with "?" instead of executing them.</summary>
    public IReadOnlyList<CommandRefusal> Refusals { get; init; } = [];

    /// <summary>Handles whose link is cut after a number of commands.</summary>
    public IReadOnlyList<HandleDrop> Drops { get; init; } = [];

    /// <summary>After this many commands no further command is answered, although motion and programs continue; null: never.</summary>
    public long? FreezeAfterCommands { get; init; }

    /// <summary>At this command the simulator throws, as in an internal error: all links are cut and <c>simulate</c> ends with exit code 70; null:
    /// never.</summary>
    public long? BreakDownAtCommand { get; init; }

    /// <summary>Wall time by which every reply is delayed.</summary>
    public TimeSpan ReplyDelay { get; init; } = TimeSpan.Zero;

    /// <summary>Faults that occur at a given controller time, segment or byte.</summary>
    public IReadOnlyList<ScheduledFault> Faults { get; init; } = [];

    /// <summary>
    /// Reads a plan as written in a faults file:
    /// <c>{"refusals":[{"command":12,"tcCode":32}],"drops":[{"handle":0,"afterCommands":40}],
    /// "freezeAfterCommands":99,"breakDownAtCommand":120,"replyDelay":"00:00:00.050"}</c>;
    /// faults with a trigger:
    /// <c>{"faults":[{"kind":"limitSwitch","atSeconds":1.5,"forSeconds":0.2,"axis":"A","forward":true},
    /// {"kind":"reset","atSegment":40},{"kind":"delay","atByte":900,"seconds":0.3}]}</c>.
    /// </summary>
    /// <exception cref="JsonException">The text is not a valid plan; a <see cref="FaultPlanException"/> when one of its faults cannot occur.</exception>
    public static FaultPlan Parse(string json)
    {
        var plan = JsonSerializer.Deserialize<FaultPlan>(json, FileFormat) ?? throw new JsonException("A fault plan is an object.");
        for (var i = 0; i < plan.Faults.Count; i++)
        {
            if (plan.Faults[i].Validate() is { } flaw) throw new FaultPlanException(i, flaw);
        }

        return plan;
    }

    private static readonly JsonSerializerOptions FileFormat = new(JsonSerializerDefaults.Web)
    {
        RespectNullableAnnotations = true,
        UnmappedMemberHandling = System.Text.Json.Serialization.JsonUnmappedMemberHandling.Disallow,
        Converters = { new System.Text.Json.Serialization.JsonStringEnumConverter<FaultKind>(JsonNamingPolicy.CamelCase, allowIntegerValues: false) },
    };

    internal int? RefusalOf(long command)
    {
        foreach (var refusal in Refusals)
        {
            if (refusal.Command == command) return refusal.TcCode;
        }

        return null;
    }
}
