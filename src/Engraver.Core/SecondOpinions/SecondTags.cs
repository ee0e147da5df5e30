using System.Globalization;
using System.Text;

namespace Engraver.Core.SecondOpinions;

/// <summary>A DXF cut into tags in the plainest way: split the lines, take two at a time. Shares nothing with the reader it checks.</summary>
internal static class SecondTags
{
    private const string BinaryMark = "AutoCAD Binary DXF\r\n\u001A\0";
    private static readonly string[] LineEnds = ["\r\r\n", "\r\n", "\n", "\r"];

    public static IEnumerable<SecondTag> Of(byte[] file)
    {
        if (Encoding.Latin1.GetString(file, 0, Math.Min(file.Length, BinaryMark.Length)) == BinaryMark) return Binary(file);
        var wide = file.Length > 1 && ((file[0] == 0xFF && file[1] == 0xFE) || file[1] == 0);
        return Ascii((wide ? Encoding.Unicode : Encoding.Latin1).GetString(file).Split(LineEnds, StringSplitOptions.None));
    }

    public static double Number(string value) => double.TryParse(value.Trim(), NumberStyles.Float, CultureInfo.InvariantCulture, out var number) ? number : double.NaN;

    private static IEnumerable<SecondTag> Ascii(string[] lines)
    {
        for (var line = 0; line + 1 < lines.Length; line++)
        {
            if (!int.TryParse(lines[line].Trim('\u00EF', '\u00BB', '\u00BF', '\uFEFF', ' ', '\t'), NumberStyles.Integer, CultureInfo.InvariantCulture, out var code)) continue;
            if (code != 999) yield return new SecondTag(code, lines[line + 1]);
            line++;
        }
    }

    private static IEnumerable<SecondTag> Binary(byte[] file)
    {
        var at = BinaryMark.Length;
        var narrow = at + 1 < file.Length && file[at] == 0 && file[at + 1] != 0;
        while (at + 2 < file.Length)
        {
            int code = narrow ? file[at++] : BitConverter.ToInt16(file, at);
            if (!narrow) at += 2;
            else if (code == 255)
            {
                code = BitConverter.ToInt16(file, at);
                at += 2;
            }

            var value = BinaryValue(file, code, ref at);
            if (value is null) yield break;
            if (code != 999) yield return new SecondTag(code, value);
        }
    }

    private static string? BinaryValue(byte[] file, int code, ref int at)
    {
        var size = SizeOf(code);
        if (size > 0 && at + size > file.Length) return null;
        at += Math.Max(size, 0);
        switch (size)
        {
            case 8 when code is >= 160 and < 170: return BitConverter.ToInt64(file, at - 8).ToString(CultureInfo.InvariantCulture);
            case 8: return BitConverter.ToDouble(file, at - 8).ToString("R", CultureInfo.InvariantCulture);
            case 4: return BitConverter.ToInt32(file, at - 4).ToString(CultureInfo.InvariantCulture);
            case 2: return BitConverter.ToInt16(file, at - 2).ToString(CultureInfo.InvariantCulture);
            case 1: return file[at - 1].ToString(CultureInfo.InvariantCulture);
        }

        var start = at;
        if (size < 0)
        {
            at = start >= file.Length ? file.Length + 1 : start + 1 + file[start];
            return at > file.Length ? null : "";
        }

        var end = Array.IndexOf(file, (byte)0, start);
        at = end + 1;
        return end < 0 ? null : Encoding.Latin1.GetString(file, start, end - start);
    }

    /// <summary>Bytes of a value; 0 a text up to a zero, -1 a chunk with its length in front.</summary>
    private static int SizeOf(int code) => code switch
    {
        >= 10 and < 60 or >= 110 and < 150 or >= 160 and < 170 or >= 210 and < 240 or >= 460 and < 470 or >= 1010 and < 1060 => 8,
        >= 90 and < 100 or >= 420 and < 430 or >= 440 and < 460 or 1071 => 4,
        >= 60 and < 80 or >= 170 and < 180 or >= 270 and < 290 or >= 370 and < 390 or >= 400 and < 410 or >= 1060 and < 1071 => 2,
        >= 290 and < 300 => 1,
        >= 310 and < 320 or 1004 => -1,
        _ => 0,
    };
}
