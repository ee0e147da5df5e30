using Engraver.Workbench.SerialTexts;

namespace Engraver.Cli.Output.Jobs;

/// <summary>What <c>engraver counters --json</c> prints; names, units and meanings are the runner's contract.</summary>
internal sealed record CounterListJson(IReadOnlyList<CounterNumber> Counters, IReadOnlyList<CounterListJson.StartedPlateJson> Plates)
{
    public static CounterListJson From(CounterState state) =>
        new(state.Counters, [.. state.Plates.Select(plate => new StartedPlateJson(plate.Values, plate.Numbers, plate.IsLeftOut, plate.Drawing, plate.Journal, plate.Date))]);

    /// <param name="LeftOut">Its numbers were left out; it can still be resumed.</param>
    internal sealed record StartedPlateJson(string Text, IReadOnlyDictionary<string, long> Numbers, bool LeftOut, string Drawing, string Journal, DateTimeOffset Date);
}
