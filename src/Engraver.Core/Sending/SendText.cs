using System.Text;
using Engraver.Core.Diagnostics;
using Engraver.Core.Posts.Agie;

namespace Engraver.Core.Sending;

/// <summary>Converts the bytes of a program file to the characters sent over the line.</summary>
public static class SendText
{
    /// <summary>The first character of a program for a wire eroder (paper 000, Table 1); a file can contain several programs.</summary>
    private const byte ProgramStart = (byte)'%';

    /// <summary>The lines of a file without their ends (CR, LF or CR LF); empty text after the last line end is not a line.</summary>
    public static IReadOnlyList<ReadOnlyMemory<byte>> Lines(ReadOnlyMemory<byte> file)
    {
        var (lines, from) = (new List<ReadOnlyMemory<byte>>(), 0);
        var bytes = file.Span;
        for (var i = 0; i < bytes.Length; i++)
        {
            if (bytes[i] is not ((byte)'\r' or (byte)'\n')) continue;
            lines.Add(file[from..i]);
            if (bytes[i] == '\r' && i + 1 < bytes.Length && bytes[i + 1] == '\n') i++;
            from = i + 1;
        }

        if (from < file.Length) lines.Add(file[from..]);
        return lines;
    }

    /// <summary>The programs for a wire eroder in the lines, each from its <c>%</c> to before the next; a single program when no line starts with it.</summary>
    /// <remarks>A control stores one program of at most 999 blocks at a time (sace-xps-agie.md 4.1: three digits for a block's number).</remarks>
    public static IReadOnlyList<IReadOnlyList<ReadOnlyMemory<byte>>> AgiePrograms(IReadOnlyList<ReadOnlyMemory<byte>> lines)
    {
        ArgumentNullException.ThrowIfNull(lines);
        var starts = Enumerable.Range(0, lines.Count).Where(i => !lines[i].IsEmpty && lines[i].Span[0] == ProgramStart).ToList();
        if (starts.Count < 2) return [lines];
        return [.. starts.Select((start, i) => (IReadOnlyList<ReadOnlyMemory<byte>>)[.. lines.Skip(start).Take((i + 1 < starts.Count ? starts[i + 1] : lines.Count) - start)])];
    }

    /// <summary>The reason why a program for a wire eroder does not fit its control; null when it fits.</summary>
    public static Diagnostic? TooLong(IReadOnlyList<ReadOnlyMemory<byte>> program)
    {
        var blocks = program.Count(line => line.Span.Trim((byte)' ') is var words && !words.IsEmpty && !words.SequenceEqual("%"u8));
        return blocks > AgieText.MaxBlocks ? SendingRules.TooManyBlocks.At(default, NumberText.Whole(blocks), NumberText.Whole(AgieText.MaxBlocks)) : null;
    }

    /// <summary>All characters to send, in their bits; or the reason why they cannot be sent.</summary>
    public static SendEncoding Encode(IReadOnlyList<ReadOnlyMemory<byte>> lines, SendFormat format, CharacterFrame frame)
    {
        ArgumentNullException.ThrowIfNull(lines);
        ArgumentNullException.ThrowIfNull(format);
        if (lines.Count == 0) return new SendEncoding(null, SendingRules.NothingToSend.At(default));
        for (var i = 0; i < lines.Count; i++)
        {
            if (frame.Largest() < byte.MaxValue && lines[i].Span.IndexOfAnyInRange((byte)(frame.Largest() + 1), byte.MaxValue) is >= 0 and var at)
                return new SendEncoding(null, SendingRules.CharacterTooLarge.At(new SourceRef(i + 1), NumberText.Whole(lines[i].Span[at]), NumberText.Whole(at + 1), NumberText.Whole(i + 1), frame.Name()));
        }

        var end = Encoding.Latin1.GetBytes(format.LineEnd);
        return new SendEncoding(new SendJob(Bits([.. new byte[format.LeaderNuls], .. Encoding.Latin1.GetBytes(format.Start)]), [.. lines.Select(line => Bits([.. line.Span, .. end]))], Bits([.. Encoding.Latin1.GetBytes(format.End), .. new byte[format.TrailerNuls]])), null);

        ReadOnlyMemory<byte> Bits(byte[] characters)
        {
            foreach (ref var character in characters.AsSpan()) character = frame.Encode(character);
            return characters;
        }
    }
}
