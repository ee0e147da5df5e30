namespace Engraver.Core.Dxf.Records;

/// <summary>A value of the extended data of a record (group codes from 1000 on).</summary>
/// <param name="Text">Of codes 1000 to 1005; "" for numbers.</param>
/// <param name="Number">Of codes above 1009; 0 for texts.</param>
internal readonly record struct ExtendedValue(int Code, string Text, double Number)
{
    /// <summary>The number as a word of 32 bits, signed or unsigned; 0 when it does not fit.</summary>
    public int Whole => Math.Abs(Number) <= uint.MaxValue ? unchecked((int)(long)Number) : 0;
}
