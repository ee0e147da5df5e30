using System.Buffers.Binary;
using System.Globalization;
using System.Security.Cryptography;
using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>Identifies a motion program by its path, segment by segment. Speeds are not included, because another link may lower them.</summary>
public static class ProgramFingerprint
{
    private const int BytesPerSegment = 40;

    /// <returns>16 hexadecimal digits.</returns>
    public static string Of(MotionProgram program)
    {
        ArgumentNullException.ThrowIfNull(program);
        using var hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        Span<byte> bytes = stackalloc byte[BytesPerSegment];
        foreach (var sequence in program.Strokes.SelectMany(stroke => stroke.Sequences))
        {
            Write(bytes, sequence.Start, sequence.Segments.Count, default);
            hash.AppendData(bytes);
            foreach (var segment in sequence.Segments)
            {
                Write(bytes, segment.End, segment.EntityIndex, segment);
                hash.AppendData(bytes);
            }
        }

        return Convert.ToHexString(hash.GetHashAndReset())[..16].ToLower(CultureInfo.InvariantCulture);
    }

    /// <summary>Writes the lowest 32 bits of a position, so that journals keep their fingerprints.</summary>
    private static void Write(Span<byte> bytes, CountsPoint point, int number, in VectorSegment segment)
    {
        BinaryPrimitives.WriteInt32LittleEndian(bytes, unchecked((int)point.X));
        BinaryPrimitives.WriteInt32LittleEndian(bytes[4..], unchecked((int)point.Y));
        BinaryPrimitives.WriteInt32LittleEndian(bytes[8..], number);
        BinaryPrimitives.WriteInt32LittleEndian(bytes[12..], (int)segment.Kind);
        BinaryPrimitives.WriteInt32LittleEndian(bytes[16..], segment.Radius);
        BinaryPrimitives.WriteDoubleLittleEndian(bytes[20..], segment.ThetaDegrees);
        BinaryPrimitives.WriteDoubleLittleEndian(bytes[28..], segment.DeltaDegrees);
        BinaryPrimitives.WriteInt32LittleEndian(bytes[36..], point.Z);
    }
}
