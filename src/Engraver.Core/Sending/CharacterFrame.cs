using System.Numerics;

namespace Engraver.Core.Sending;

/// <summary>Data bits and parity of a character; one stop bit.</summary>
public enum CharacterFrame : byte
{
    /// <summary>8N1.</summary>
    EightNone,

    /// <summary>7E1, the code of ISO tapes: the number of ones with the parity bit is even.</summary>
    SevenEven,

    /// <summary>7O1.</summary>
    SevenOdd,
}

/// <summary>Characters as the eight bits between start and stop bit. The parity is computed here and sent as the eighth bit, so that every device that supports
/// 8N1 can send all frames.</summary>
public static class CharacterFrames
{
    private const int Low = 0x7F;
    private const int ParityBit = 0x80;

    private static readonly (CharacterFrame Frame, string Name)[] s_names = [(CharacterFrame.EightNone, "8N1"), (CharacterFrame.SevenEven, "7E1"), (CharacterFrame.SevenOdd, "7O1")];

    /// <summary>The frame named 8N1, 7E1 or 7O1, in upper or lower case; null for any other name.</summary>
    public static CharacterFrame? Find(string name) => s_names.Where(known => known.Name.Equals(name, StringComparison.OrdinalIgnoreCase)).Select(known => (CharacterFrame?)known.Frame).FirstOrDefault();

    public static string Name(this CharacterFrame frame) => s_names.First(known => known.Frame == frame).Name;

    /// <summary>The largest character that can be sent.</summary>
    public static byte Largest(this CharacterFrame frame) => frame == CharacterFrame.EightNone ? byte.MaxValue : (byte)Low;

    /// <summary>The bits of a character that is not larger than <see cref="Largest"/>.</summary>
    public static byte Encode(this CharacterFrame frame, byte character) => frame switch
    {
        CharacterFrame.EightNone => character,
        CharacterFrame.SevenEven => (byte)(IsOdd(character) ? character | ParityBit : character),
        _ => (byte)(IsOdd(character) ? character : character | ParityBit),
    };

    /// <summary>The character of the received bits; its parity bit is removed without a check.</summary>
    public static byte Decode(this CharacterFrame frame, byte bits) => frame == CharacterFrame.EightNone ? bits : (byte)(bits & Low);

    /// <summary>True when the parity of the received bits is correct.</summary>
    public static bool HasValidParity(this CharacterFrame frame, byte bits) => frame.Encode(frame.Decode(bits)) == bits;

    private static bool IsOdd(byte character) => (BitOperations.PopCount(character) & 1) == 1;
}
