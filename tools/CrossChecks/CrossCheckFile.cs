using System.Globalization;
using System.Text;

namespace Engraver.Tools.CrossChecks;

/// <summary>A DXF file cut into tags: two lines at a time, or in a binary file a code and its bytes. Of a tag only its place is kept. Shares no code with
/// the reader that it checks.</summary>
internal sealed class CrossCheckFile
{
    private const string BinaryMark = "AutoCAD Binary DXF\r\n\u001A\0";
    private readonly byte[] _bytes;
    private readonly bool _binary;

    public CrossCheckFile(byte[] file)
    {
        _binary = Encoding.Latin1.GetString(file, 0, Math.Min(file.Length, BinaryMark.Length)) == BinaryMark;
        var wide = _binary || file.Length < 2 ? null
            : (file[0] == 0xFF && file[1] == 0xFE) || file[1] == 0 ? Encoding.Unicode
            : (file[0] == 0xFE && file[1] == 0xFF) || file[0] == 0 ? Encoding.BigEndianUnicode : null;
        _bytes = wide is null ? file : Encoding.Latin1.GetBytes(wide.GetString(file).TrimStart('\uFEFF'));
    }

    /// <summary>Code of the tag for a line that should be a group code but is not.</summary>
    public const int Damaged = int.MinValue;

    public IEnumerable<CrossCheckTag> Tags => TagsAndDamage.Where(tag => tag.Code != Damaged);

    /// <summary>The tags, and between them the lines that are skipped because they are not group codes (<see cref="Damaged"/>).</summary>
    public IEnumerable<CrossCheckTag> TagsAndDamage => _binary ? CrossCheckBinary.Tags(_bytes, BinaryMark.Length) : Ascii();

    /// <summary>True when a line of text has zero bytes in it: that part of the file was never written.</summary>
    public bool HasZero(CrossCheckTag tag) => !_binary && _bytes.AsSpan(tag.Start, tag.Length).Contains((byte)0);

    /// <summary>A phrase for the place of a tag's value: its line, in a binary file its byte.</summary>
    public string Place(CrossCheckTag tag)
    {
        if (_binary) return Wording.Get("CrossCheckFile.Byte", tag.Start);
        var before = _bytes.AsSpan(0, tag.Start);
        return Wording.Get("CrossCheckFile.Line", Math.Max(before.Count((byte)'\n'), before.Count((byte)'\r')) + 1);
    }

    /// <summary>The value as a line of an ASCII file would have it.</summary>
    public string Line(CrossCheckTag tag) => _binary && CrossCheckBinary.SizeOf(tag.Code) > 0
        ? CrossCheckBinary.Number(_bytes, tag).ToString("R", CultureInfo.InvariantCulture)
        : Encoding.Latin1.GetString(_bytes, tag.Start, tag.Length);

    public string Text(CrossCheckTag tag) => Encoding.Latin1.GetString(_bytes, tag.Start, tag.Length).Trim();

    /// <summary>The value as a number, NaN when it is not one: nothing is repaired, so that every repair of the reader shows as a difference.</summary>
    public double Number(CrossCheckTag tag)
    {
        if (_binary && CrossCheckBinary.SizeOf(tag.Code) > 0) return CrossCheckBinary.Number(_bytes, tag);
        return double.TryParse(_bytes.AsSpan(tag.Start, tag.Length), NumberStyles.Float, CultureInfo.InvariantCulture, out var number) ? number : double.NaN;
    }

    /// <summary>The tags of a text file. A line that should be a code but is not is skipped alone, because the next may be one.</summary>
    private IEnumerable<CrossCheckTag> Ascii()
    {
        for (var at = 0; at < _bytes.Length;)
        {
            var (codeEnd, valueStart) = LineFrom(at);
            if (valueStart < 0) yield break;
            if (Code(at, codeEnd) is not { } code)
            {
                if (!_bytes.AsSpan(at, codeEnd - at).Trim(" \t"u8).IsEmpty) yield return new CrossCheckTag(Damaged, at, codeEnd - at);
                at = valueStart;
                continue;
            }

            var (valueEnd, next) = LineFrom(valueStart);
            if (code != 999) yield return new CrossCheckTag(code, valueStart, valueEnd - valueStart);
            at = next < 0 ? _bytes.Length : next;
        }
    }

    private int? Code(int start, int end)
    {
        ReadOnlySpan<byte> line = _bytes.AsSpan(start, end - start);
        line = line.Trim((ReadOnlySpan<byte>)[0xEF, 0xBB, 0xBF, (byte)' ', (byte)'\t']);
        return int.TryParse(line, NumberStyles.Integer, CultureInfo.InvariantCulture, out var code) ? code : null;
    }

    /// <summary>Where a line ends and where the next begins; -1 when it is the last. LF, CR, CR LF, CR CR LF and LF CR end a line.</summary>
    private (int End, int Next) LineFrom(int start)
    {
        var length = _bytes.AsSpan(start).IndexOfAny((byte)'\r', (byte)'\n');
        if (length < 0) return (_bytes.Length, -1);
        var end = start + length;
        var next = end;
        while (next < end + 2 && next < _bytes.Length && _bytes[next] == '\r') next++;
        if (next < _bytes.Length && _bytes[next] == '\n') next++;
        else next = end + 1;
        if (_bytes[end] == '\n' && next + 1 < _bytes.Length && _bytes[next] == '\r' && _bytes[next + 1] is not ((byte)'\r' or (byte)'\n')) next++;
        return (end, next);
    }
}

/// <summary>A group code, and the position of its value in the file.</summary>
internal readonly record struct CrossCheckTag(int Code, int Start, int Length);
