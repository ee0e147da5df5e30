using System.Text;
using Engraver.Core.Machines;

namespace Engraver.Workbench.Tests.Machines;

/// <summary>What the wires of one run have carried, and which line is harmed on its way to the controller.</summary>
/// <param name="harmAt">Place of the line among those that can be harmed, from 0; -1 for none.</param>
internal class HarmingWire(int harmAt, int seed)
{
    /// <summary>So many lines are far more than any run of the test's drawing takes: whoever sends more does not end.</summary>
    private const int MostLines = 60_000;

    private readonly Random _random = new(seed);
    private int _lines;

    /// <summary>Motion and setting commands, and lines of programs, seen so far.</summary>
    public int Harmable { get; private set; }

    /// <summary>The harmed line as it was and as it went on; null before.</summary>
    public (string Was, string Became)? Harmed { get; private set; }

    /// <summary>The run sent more than it ever should.</summary>
    public bool IsHung => _lines > MostLines;

    /// <returns>What goes on to the controller.</returns>
    /// <exception cref="IOException">The run does not end.</exception>
    public string Carry(string text)
    {
        if (++_lines > MostLines) throw new IOException("More lines than any run takes.");
        var lines = text.Split('\r');
        for (var i = 0; i < lines.Length; i++)
        {
            var inProgram = lines[0] == "DL" && i > 0 && i < lines.Length - 1;
            if (!inProgram && (lines[0] == "DL" || !IsCommand(lines[i]))) continue;
            var was = lines[i];
            if (Harm(was) is { } harmed) (lines[i], Harmed) = (harmed, (was, harmed));
        }

        return string.Join('\r', lines);
    }

    /// <returns>What becomes of a line that can be harmed; null when it goes on as it is.</returns>
    protected virtual string? Harm(string line) => Harmable++ == harmAt ? HarmedByte.Of(line, _random) : null;

    /// <summary>Questions carry nothing that could harm a run, and heartbeats come by the thousand.</summary>
    private static bool IsCommand(string line) =>
        line.Length > 1 && char.IsAsciiLetter(line[0]) && !(line.StartsWith("hb=", StringComparison.Ordinal) && !line.Contains(';', StringComparison.Ordinal))
        && !new[] { "MG", "TC", "UL", "QZ", "WH", "EO" }.Any(question => line.StartsWith(question, StringComparison.Ordinal));
}

/// <summary>A link through a wire that harms bytes: every write is one line, or one download.</summary>
internal sealed class HarmingLink(IControllerLink inner, HarmingWire wire) : IControllerLink
{
    public string Description => inner.Description;

    public SerialLine? Line => inner.Line;

    public ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation) =>
        inner.WriteAsync(Encoding.Latin1.GetBytes(wire.Carry(Encoding.Latin1.GetString(bytes.Span))), cancellation);

    public ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation) => inner.ReadAsync(buffer, cancellation);

    public ValueTask DisposeAsync() => inner.DisposeAsync();
}
