using System.Buffers;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Text;

namespace Engraver.Core.Dxf.Tags;

/// <summary>Pairs of lines: a group code, then its value. Line ends may be LF, CR LF, CR CR LF, LF CR or CR, also mixed; codes may have blanks around
/// them.</summary>
internal sealed class AsciiTagSource : DxfTagSource
{
    private const int ShownText = 40;

    /// <summary>Bytes that must remain in the file for the fast reading of a pair, which does not test for the end at every byte.</summary>
    private const int PlainMargin = 64;

    private const int MaxBlanks = 8;

    /// <summary>Minimum number of bytes to wait for before a pair is read: in a DXF of AutoCAD no line has more than 2,049.</summary>
    private const int MinBytesAhead = 1 << 12;

    private static readonly SearchValues<byte> KeywordBytes = SearchValues.Create("ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_"u8);
    private int _valueStart;
    private int _valueLength;

    public AsciiTagSource(IProgressiveBytes file)
        : base(file)
    {
        NextLine = 1;
        WaitFor(MinBytesAhead);
        if (Bytes.StartsWith("\uFEFF"u8)) Position = 3;
    }

    public override bool IsBinary => false;

    public override ReadOnlySpan<byte> Value => Bytes.Slice(_valueStart, _valueLength);

    public override bool TryNumber(out double number) => DxfNumber.TryParse(Value, out number);

    /// <summary>Reads a common pair fast; an unusual one is not consumed and is read by the general method.</summary>
    protected override bool ReadPair() => TryPlainPair() || TryIncompletePair() || ReadAnyPair();

    /// <summary>While the file arrives: waits for more where the pair may be incomplete, and for the whole file where it is unusual, because the general method
    /// reads ahead to the end.</summary>
    private bool TryIncompletePair()
    {
        while (!IsWhole)
        {
            if (Bytes.Length - Position < MinBytesAhead) WaitFor((int)Math.Min((long)Position + MinBytesAhead, int.MaxValue));
            else WaitForAll();
            if (TryPlainPair()) return true;
        }

        return false;
    }

    /// <summary>A common pair: blanks, one to four digits, LF or CR LF; a value with the same line end, well before the end of the file.</summary>
    private bool TryPlainPair()
    {
        var bytes = Bytes;
        var at = Position;
        if (bytes.Length - at < PlainMargin) return false;
        ref var first = ref MemoryMarshal.GetReference(bytes);
        while (Unsafe.Add(ref first, at) == ' ' && at - Position < MaxBlanks) at++;
        var code = (uint)Unsafe.Add(ref first, at) - '0';
        if (code > 9) return false;
        var digit = (uint)Unsafe.Add(ref first, ++at) - '0';
        for (var digits = 1; digit <= 9 && digits < 4; digits++)
        {
            code = (code * 10) + digit;
            digit = (uint)Unsafe.Add(ref first, ++at) - '0';
        }

        if (!TakePlainEnd(ref first, ref at)) return false;
        var start = at;
        if (!LineEnd.TryFind(bytes, ref at)) return false;
        var end = at;
        if (!TakePlainEnd(ref first, ref at)) return false;
        (Code, Line, _valueStart, _valueLength, Position) = ((int)code, NextLine, start, end - start, at);
        CutInsidePair = false;
        NextLine += 2;
        return true;
    }

    /// <summary>Steps over LF or CR LF.</summary>
    private static bool TakePlainEnd(ref byte first, ref int at)
    {
        if (Unsafe.Add(ref first, at) == '\r') at++;
        return Unsafe.Add(ref first, at++) == '\n';
    }

    private bool ReadAnyPair()
    {
        while (TakeLine(out var start, out var length, out _))
        {
            var line = Bytes.Slice(start, length);
            if (TryCode(line, out var code))
            {
                Code = code;
                Line = NextLine - 1;
                var complete = TakeLine(out _valueStart, out _valueLength, out var ended);
                CutInsidePair = !complete || !ended;
                return complete;
            }

            if (IsBlank(line)) continue; // a superfluous empty line: the pairs after it are valid
            Damage(NextLine - 1, Encoding.Latin1.GetString(line[..Math.Min(length, ShownText)]));
            if (Value.Trim(" \t"u8).SequenceEqual("0"u8) && IsKeyword(line))
            {
                // The pairs were shifted by one line and the "0" of this record was taken for a value: from here they are aligned again.
                Code = 0;
                Line = NextLine - 2;
                (_valueStart, _valueLength) = (start, length);
                return true;
            }

            SkipToNextRecord();
        }

        return false;
    }

    public override (int Count, int Line) ZeroBytes()
    {
        var text = Bytes[..Position].TrimEnd("\0\u001A \t\r\n"u8);
        var first = text.IndexOf((byte)0);
        return first < 0 ? default : (text.Count((byte)0), LineOf(first));
    }

    private int LineOf(int offset)
    {
        var here = Bookmark();
        Return((0, 1));
        while (Position <= offset && TakeLine(out _, out _, out _))
        {
        }

        var line = NextLine - 1;
        Return(here);
        return line;
    }

    private static bool IsBlank(ReadOnlySpan<byte> line) => line.Trim(" \t\0\u001A"u8).IsEmpty;

    /// <summary>A whole number from -5 to 1071 (the group codes of the format), of up to five digits; false for anything else.</summary>
    private static bool TryCode(ReadOnlySpan<byte> line, out int code)
    {
        code = 0;
        var at = 0;
        while (at < line.Length && line[at] is (byte)' ' or (byte)'\t') at++;
        var negative = at < line.Length && line[at] == '-';
        if (negative || (at < line.Length && line[at] == '+')) at++;
        var first = at;
        for (; at < line.Length && (uint)line[at] - '0' <= 9; at++)
        {
            code = (code * 10) + line[at] - '0';
            if (at - first >= 5) return false;
        }

        var digits = at - first;
        while (at < line.Length && line[at] is (byte)' ' or (byte)'\t') at++;
        if (negative) code = -code;
        return digits > 0 && at == line.Length;
    }

    /// <summary>After a line that is not a group code the pairs may be shifted by one line; at a "0" followed by a keyword they are aligned again.</summary>
    private void SkipToNextRecord()
    {
        while (true)
        {
            var (place, number) = Bookmark();
            if (!TakeLine(out var start, out var length, out _)) return;
            if (!TryCode(Bytes.Slice(start, length), out var code) || code != 0) continue;
            var afterCode = Bookmark();
            if (!TakeLine(out start, out length, out _)) return;
            if (IsKeyword(Bytes.Slice(start, length)))
            {
                Return((place, number));
                return;
            }

            Return(afterCode);
        }
    }

    private static bool IsKeyword(ReadOnlySpan<byte> line)
    {
        var word = line.Trim(" \t"u8);
        return word.Length > 2 && char.IsAsciiLetterOrDigit((char)word[0]) && word.IndexOfAnyInRange((byte)'A', (byte)'Z') >= 0
            && word.IndexOfAnyExcept(KeywordBytes) < 0;
    }

    /// <summary>The next line without its end; <paramref name="ended"/> is false when the file stops without one.</summary>
    private bool TakeLine(out int start, out int length, out bool ended)
    {
        var bytes = Bytes;
        start = Position;
        if (start >= bytes.Length)
        {
            length = 0;
            ended = false;
            return false;
        }

        length = bytes[start..].IndexOfAny((byte)'\n', (byte)'\r');
        ended = length >= 0;
        if (!ended) length = bytes.Length - start;
        var end = start + length;
        if (ended) end += LineEndLength(bytes[end..]);
        Position = end;
        NextLine++;
        return true;
    }

    private static int LineEndLength(ReadOnlySpan<byte> end)
    {
        if (end[0] == '\n') return end.Length > 2 && end[1] == '\r' && end[2] is not ((byte)'\n' or (byte)'\r') ? 2 : 1;
        if (end.Length > 1 && end[1] == '\n') return 2;
        return end.Length > 2 && end[1] == '\r' && end[2] == '\n' ? 3 : 1;
    }
}
