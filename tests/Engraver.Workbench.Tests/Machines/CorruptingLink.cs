using System.Text;
using Engraver.Core.Machines;

namespace Engraver.Workbench.Tests.Machines;

/// <summary>The lines transferred in one run, and the line that is corrupted on its way to the controller.</summary>
/// <param name="harmAt">Index of the line among those that can be corrupted, from 0; -1 for none.</param>
internal class CorruptingWire(int harmAt, int seed)
{
    /// <summary>More lines than any run of the test drawing needs: a run that sends more does not end.</summary>
    private const int MostLines = 60_000;

    private readonly Random _random = new(seed);
    private int _lines;

    /// <summary>Motion and setting commands, and lines of programs, seen so far.</summary>
    public int Harmable { get; private set; }

    /// <summary>The corrupted line before and after; null until then.</summary>
    public (string Was, string Became)? Corrupted { get; private set; }

    /// <summary>The run sent too many lines.</summary>
    public bool IsHung => _lines > MostLines;

    /// <returns>The line for the controller.</returns>
    /// <exception cref="IOException">The run does not end.</exception>
    public string Pass(string text)
    {
        if (++_lines > MostLines) throw new IOException("More lines than any run takes.");
        var lines = text.Split('\r');
        for (var i = 0; i < lines.Length; i++)
        {
            var inProgram = lines[0] == "DL" && i > 0 && i < lines.Length - 1;
            if (!inProgram && (lines[0] == "DL" || !IsCommand(lines[i]))) continue;
            var was = lines[i];
            if (Corrupt(was) is { } harmed) (lines[i], Corrupted) = (harmed, (was, harmed));
        }

        return string.Join('\r', lines);
    }

    /// <returns>The corrupted line; null if it is unchanged.</returns>
    protected virtual string? Corrupt(string line) => Harmable++ == harmAt ? CorruptedByte.Of(line, _random) : null;

    /// <summary>Queries cannot affect a run, and there are thousands of heartbeats.</summary>
    private static bool IsCommand(string line) =>
        line.Length > 1 && char.IsAsciiLetter(line[0]) && !(line.StartsWith("hb=", StringComparison.Ordinal) && !line.Contains(';', StringComparison.Ordinal))
        && !new[] { "MG", "TC", "UL", "QZ", "WH", "EO" }.Any(question => line.StartsWith(question, StringComparison.Ordinal));
}

/// <summary>A link that corrupts bytes: every write is one line, or one download.</summary>
internal sealed class CorruptingLink(IControllerLink inner, CorruptingWire wire) : IControllerLink
{
    public string Description => inner.Description;

    public SerialLine? Line => inner.Line;

    public ValueTask WriteAsync(ReadOnlyMemory<byte> bytes, CancellationToken cancellation) =>
        inner.WriteAsync(Encoding.Latin1.GetBytes(wire.Pass(Encoding.Latin1.GetString(bytes.Span))), cancellation);

    public ValueTask<int> ReadAsync(Memory<byte> buffer, CancellationToken cancellation) => inner.ReadAsync(buffer, cancellation);

    public ValueTask DisposeAsync() => inner.DisposeAsync();
}
