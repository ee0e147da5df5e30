using System.Collections.Frozen;

namespace Engraver.Simulator.Commands;

/// <summary>Every command this controller knows; what is not here is answered "?" with TC 1 and listed in docs/simulator-fidelity.md.</summary>
internal static class CommandTable
{
    private static readonly FrozenDictionary<string, CommandEntry> Table = new[]
    {
        FlowCommands.Entries,
        TrippointCommands.Entries,
        IndependentCommands.Entries,
        AxisParameters.Entries,
        VectorCommands.Entries,
        StopCommands.Entries,
        IoCommands.Entries,
        ReportCommands.Entries,
        MemoryCommands.Entries,
        LinkCommands.Entries,
        SystemCommands.Entries,
    }.SelectMany(e => e).ToFrozenDictionary(e => e.Mnemonic, StringComparer.Ordinal);

    private static readonly FrozenDictionary<string, CommandEntry>.AlternateLookup<ReadOnlySpan<char>> Lookup =
        Table.GetAlternateLookup<ReadOnlySpan<char>>();

    public static IEnumerable<string> Mnemonics => Table.Keys;

    /// <summary>The command a statement begins with; the long words first, because ENDIF must not be read as EN (L.2 point 9).</summary>
    public static CommandEntry? Find(ReadOnlySpan<char> statement) =>
        statement.StartsWith("ENDIF") ? Get("ENDIF")
        : statement.StartsWith("ELSE") ? Get("ELSE")
        : statement.Length >= 2 ? Get(statement[..2])
        : null;

    private static CommandEntry? Get(ReadOnlySpan<char> mnemonic) => Lookup.TryGetValue(mnemonic, out var entry) ? entry : null;
}
