using System.Buffers.Binary;
using System.Security.Cryptography;
using Engraver.Core.Geometry;

namespace Engraver.Core.Verification;

/// <summary>A short text that identifies the curves of a drawing, independent of the position and speed of the cut. Curves that are a millionth of a millimetre
/// apart are the same.</summary>
public static class DrawnFingerprint
{
    private const double PerMillimetre = 1e6;

    /// <param name="drawing">Segments in millimetres, in the order of the drawing.</param>
    /// <returns>16 hexadecimal digits.</returns>
    public static string Of(IReadOnlyList<Segment> drawing)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        using var hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        Span<byte> bytes = stackalloc byte[7 * sizeof(long)];
        foreach (var segment in drawing)
        {
            var middle = segment.PointAt(0.5);
            double[] numbers = [segment.Start.X, segment.Start.Y, middle.X, middle.Y, segment.End.X, segment.End.Y];
            for (var i = 0; i < numbers.Length; i++) BinaryPrimitives.WriteInt64LittleEndian(bytes[(i * sizeof(long))..], (long)Math.Round(numbers[i] * PerMillimetre));
            BinaryPrimitives.WriteInt64LittleEndian(bytes[(numbers.Length * sizeof(long))..], (long)segment.Kind);
            hash.AppendData(bytes);
        }

        return Convert.ToHexStringLower(hash.GetHashAndReset().AsSpan(0, 8));
    }
}
