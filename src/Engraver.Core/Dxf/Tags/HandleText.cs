using System.Globalization;

namespace Engraver.Core.Dxf.Tags;

/// <summary>Handles as a DXF writes them.</summary>
internal static class HandleText
{
    /// <summary>A handle as written: hexadecimal, blanks around it allowed; 0 when it is not one.</summary>
    public static ulong Parse(ReadOnlySpan<byte> text)
    {
        var handle = 0UL;
        foreach (var character in text)
        {
            var digit = (uint)character - '0';
            if (digit > 9) digit = ((uint)character | 0x20) - 'a' is <= 5 and var letter ? letter + 10 : 16;
            if (digit > 15 || handle >> 60 != 0) return Other(text);
            handle = (handle << 4) | digit;
        }

        return handle;
    }

    private static ulong Other(ReadOnlySpan<byte> text) => ulong.TryParse(text, NumberStyles.HexNumber, CultureInfo.InvariantCulture, out var handle) ? handle : 0;
}
