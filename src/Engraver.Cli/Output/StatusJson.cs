using Engraver.Core.Geometry;
using Engraver.Core.Machines.Origins;
using Engraver.Workbench.Machines;

namespace Engraver.Cli.Output;

/// <summary>The one object of <c>status</c>, <c>zero</c> and <c>goto</c>: what the machine is doing and where it stands, millimetres.</summary>
/// <param name="State">One of the states of the contract, upper case with blanks.</param>
/// <param name="Machine">By the controller's own zero.</param>
/// <param name="Work">By the active work origin.</param>
/// <param name="Inputs">Name to state; 1 is on.</param>
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

    public static StatusJson From(MachineStatus status, MachineMemory? memory)
    {
        ArgumentNullException.ThrowIfNull(status);
        return new StatusJson(
            StateText(status.State),
            Homed: false,
            new PlaceJson(status.MachinePosition?.X, status.MachinePosition?.Y, null),
            new WorkJson(memory?.Active ?? WorkOriginNames.First, status.WorkPosition?.X, status.WorkPosition?.Y, null),
            [.. (status.MotorsOff ?? "").Select(letter => letter.ToString())],
            status.Limit.Length == 0 ? [] : status.Limit.Split(" and "),
            Bits(status.Inputs),
            Bits(status.Outputs),
            status.Controller);
    }

    /// <summary>For people: three lines.</summary>
    public IEnumerable<string> Text()
    {
        yield return $"{State}, {Model}";
        yield return Wording.Get("Status.Machine", Place(Machine.X, Machine.Y));
        yield return Work.X is null ? Wording.Get("Status.WorkNotSet", Work.Name) : Wording.Get("Status.Work", Work.Name, Place(Work.X, Work.Y));
    }

    private static string Place(double? x, double? y) => x is { } atX && y is { } atY ? Wording.Get("Status.Place", atX, atY) : Wording.Get("Status.NotKnown");

    private static string StateText(MachineState state) => state switch
    {
        MachineState.MotorsOff => "MOTORS OFF",
        MachineState.EmergencyStopOpen => "E-STOP OPEN",
        _ => state.ToString().ToUpperInvariant(),
    };

    private static Dictionary<string, int> Bits(int? word) => word is not { } bits ? [] : Enumerable.Range(1, Lines).ToDictionary(line => line.ToString(System.Globalization.CultureInfo.InvariantCulture), line => (bits >> (line - 1)) & 1);

    internal sealed record PlaceJson(double? X, double? Y, double? Z);

    internal sealed record WorkJson(string Name, double? X, double? Y, double? Z);
}
