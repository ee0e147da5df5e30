using System.Collections.Frozen;

namespace Engraver.Simulator.Language.Commands;

/// <summary>Every command that this controller supports; any other command is answered with "?" and TC 1 and is listed in docs/simulator-fidelity.md.</summary>
internal static class CommandTable
{
    private static readonly FrozenDictionary<string, CommandEntry> Table = new[]
    {
        FlowCommands.Entries,
        TrippointCommands.Entries,
        IndependentCommands.Entries,
        AxisParameters.Entries,
        VectorCommands.Entries,
        SegmentCommands.Entries,
        PlaneSettings.Entries,
        HomingCommands.Entries,
        GearCommands.Entries,
        CamCommands.Entries,
        ContourCommands.Entries,
        CaptureCommands.Entries,
        InterruptCommands.Entries,
        StopCommands.Entries,
        IoCommands.Entries,
        ReportCommands.Entries,
        MemoryCommands.Entries,
        LinkCommands.Entries,
        SystemCommands.Entries,
    }.SelectMany(e => e).ToFrozenDictionary(e => e.Mnemonic, StringComparer.Ordinal);

    private static readonly FrozenDictionary<string, CommandEntry>.AlternateLookup<ReadOnlySpan<char>> Lookup =
        Table.GetAlternateLookup<ReadOnlySpan<char>>();

    /// <summary>Commands that a DMC-21x3 has and this controller does not (galil-dmc.md 0.4). They must be recognised, otherwise EAC=1 would be read as a
    /// variable.</summary>
    private static readonly FrozenSet<string> Absent = (
        "AF AG AO AQ AU BA BC BD BI BK BM BR BZ DV ED EW GD HS IA IK LC MB MW NB NF NZ "
        + "OC PL QH QS SL TA TZ YA YB YC YR YS").Split(' ').ToFrozenSet(StringComparer.Ordinal);

    public static IEnumerable<string> Mnemonics => Table.Keys;

    public static IEnumerable<string> NotModelled => Absent;

    public static bool IsNotModelled(string mnemonic) => Absent.Contains(mnemonic);

    /// <summary>The command that a statement begins with. Longer mnemonics are tried first, otherwise ENDIF would be read as EN (L.2 point 9).</summary>
    public static CommandEntry? Find(ReadOnlySpan<char> statement) =>
        statement.StartsWith("ENDIF") ? Get("ENDIF")
        : statement.StartsWith("ELSE") ? Get("ELSE")
        : statement.Length >= 2 ? Get(statement[..2])
        : null;

    private static CommandEntry? Get(ReadOnlySpan<char> mnemonic) => Lookup.TryGetValue(mnemonic, out var entry) ? entry : null;
}
