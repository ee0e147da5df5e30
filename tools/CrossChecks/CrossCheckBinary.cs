namespace Engraver.Tools.CrossChecks;

/// <summary>Tags of a binary DXF, with codes of two bytes or (R12 and before) of one.</summary>
internal static class CrossCheckBinary
{
    public static IEnumerable<CrossCheckTag> Tags(byte[] file, int at)
    {
        var narrow = at + 1 < file.Length && ((file[at] == 0 && file[at + 1] != 0) || file[at] == 255);
        while (at + 2 < file.Length)
        {
            int code = narrow ? file[at++] : BitConverter.ToInt16(file, at);
            if (!narrow) at += 2;
            else if (code == 255)
            {
                code = BitConverter.ToInt16(file, at);
                at += 2;
            }

            if (Value(file, code, ref at) is not { } tag) yield break;
            if (code != 999) yield return tag;
        }
    }

    public static double Number(byte[] file, CrossCheckTag tag) => tag.Length switch
    {
        8 when tag.Code is >= 160 and < 170 => BitConverter.ToInt64(file, tag.Start),
        8 => BitConverter.ToDouble(file, tag.Start),
        4 => BitConverter.ToInt32(file, tag.Start),
        2 => BitConverter.ToInt16(file, tag.Start),
        _ => file[tag.Start],
    };

    /// <summary>Number of bytes of a value by its group code; 0 for a text that ends with a zero byte, -1 for a chunk that starts with its
    /// length.</summary>
    public static int SizeOf(int code) => code switch
    {
        >= 10 and < 60 or >= 110 and < 150 or >= 160 and < 170 or >= 210 and < 240 or >= 460 and < 470 or >= 1010 and < 1060 => 8,
        >= 90 and < 100 or >= 420 and < 430 or >= 440 and < 460 or 1071 => 4,
        >= 60 and < 80 or >= 170 and < 180 or >= 270 and < 290 or >= 370 and < 390 or >= 400 and < 410 or >= 1060 and < 1071 => 2,
        >= 290 and < 300 => 1,
        >= 310 and < 320 or 1004 => -1,
        _ => 0,
    };

    private static CrossCheckTag? Value(byte[] file, int code, ref int at)
    {
        var (start, size) = (at, SizeOf(code));
        if (size < 0)
        {
            at = start >= file.Length ? file.Length + 1 : start + 1 + file[start];
            return at > file.Length ? null : new CrossCheckTag(code, start, 0);
        }

        var length = size > 0 ? size : Array.IndexOf(file, (byte)0, start) - start;
        if (length < 0 || start + length > file.Length) return null;
        at = start + length + (size > 0 ? 0 : 1);
        return new CrossCheckTag(code, start, length);
    }
}
