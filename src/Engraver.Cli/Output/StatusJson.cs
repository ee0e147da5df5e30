using System.Globalization;
using System.Text.Json.Serialization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Output;

/// <summary>The one object of <c>status</c>, <c>zero</c> and <c>goto</c>: state and position of the machine, millimetres.</summary>
/// <param name="State">One of the states of the contract, upper case with blanks.</param>
/// <param name="Machine">Relative to the controller's zero.</param>
/// <param name="Work">Relative to the active work origin; null while its position is unknown.</param>
/// <param name="Inputs">Name to state; 1 is on. The number is the name if the machine profile has no name for it or the name is already used.</param>
internal sealed record StatusJson(
    string State,
    bool Homed,
    StatusJson.PlaceJson Machine,
    StatusJson.WorkJson Work,
    IReadOnlyList<string> MotorsOff,
    IReadOnlyList<string> Limits,
    IReadOnlyDictionary<string, int> Inputs,
    IReadOnlyDictionary<string, int> Outputs,
    string? Model)
{
    private const int Lines = 8;

    /// <summary>The start checks of a frame run; omitted by verbs without checks.</summary>
    [JsonIgnore(Condition = JsonIgnoreCondition.WhenWritingNull)]
    public IReadOnlyList<StartCheckJson>? Checks { get; init; }

    /// <summary>Why the work origin is unknown, and what to do; null while it is known.</summary>
    [JsonIgnore]
    public Diagnostic? OriginMissing { get; private init; }

    public static StatusJson From(MachineStatus status, StoredMachineState? memory, MachineProfile profile)
    {
        ArgumentNullException.ThrowIfNull(status);
        ArgumentNullException.ThrowIfNull(profile);
        var (active, isKnown) = (memory?.Active ?? WorkOriginNames.First, status.OriginMissing is null);
        return new StatusJson(
            status.State.Token(),
            Homed: status.IsHomed == true,
            new PlaceJson(status.MachinePosition?.X, status.MachinePosition?.Y, status.MachineHeight),
            isKnown ? new WorkJson(active, status.WorkPosition?.X, status.WorkPosition?.Y, status.WorkHeight) : new WorkJson(active, null, null, null),
            [.. (status.MotorsOff ?? "").Select(letter => letter.ToString())],
            status.Limit.Length == 0 ? [] : status.Limit.Split(", "),
            Bits(status.Inputs, profile.Inputs),
            Bits(status.Outputs, profile.Outputs),
            status.Controller) { OriginMissing = status.OriginMissing };
    }

    /// <summary>Three lines of text.</summary>
    public IEnumerable<string> Text()
    {
        yield return $"{State}, {Model}";
        yield return Wording.Get("Status.Machine", Place(Machine.X, Machine.Y, Machine.Z));
        if (OriginMissing is { } missing) yield return Wording.Get("Status.WorkMissing", Work.Name, SettingWording.OnConsole(missing).Message);
        else yield return Work.X is null ? Wording.Get("Status.WorkNotSet", Work.Name) : Wording.Get("Status.Work", Work.Name, Place(Work.X, Work.Y, Work.Z));
    }

    private static string Place(double? x, double? y, double? z)
    {
        if (x is not { } atX || y is not { } atY) return Wording.Get("Status.NotKnown");
        return z is { } atZ ? Wording.Get("Status.PlaceWithZ", atX, atY, atZ) : Wording.Get("Status.Place", atX, atY);
    }

    private static Dictionary<string, int> Bits(int? word, IoLineNames names)
    {
        var states = new Dictionary<string, int>(StringComparer.OrdinalIgnoreCase);
        if (word is not { } bits) return states;
        for (var line = 1; line <= Lines; line++)
        {
            var state = (bits >> (line - 1)) & 1;
            var number = line.ToString(CultureInfo.InvariantCulture);
            var isOwn = !int.TryParse(names[line], out _) && !states.ContainsKey(names[line]);
            states[isOwn ? names[line] : number] = state;
        }

        return states;
    }

    internal sealed record PlaceJson(double? X, double? Y, double? Z);

    internal sealed record WorkJson(string Name, double? X, double? Y, double? Z);
}
