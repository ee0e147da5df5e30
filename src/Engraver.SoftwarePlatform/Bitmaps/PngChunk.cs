using System.Buffers.Binary;
using System.Text;

namespace Engraver.SoftwarePlatform.Bitmaps;

/// <summary>One piece of a PNG file: four letters, data, checksum.</summary>
internal readonly record struct PngChunk(string Name, ReadOnlyMemory<byte> Data)
{
    private const int LengthAndName = 8;

    public static ReadOnlySpan<byte> Signature => [137, 80, 78, 71, 13, 10, 26, 10];

    /// <summary>The chunks up to IEND.</summary>
    public static IEnumerable<PngChunk> All(ReadOnlyMemory<byte> file)
    {
        if (!file.Span.StartsWith(Signature))
            throw new InvalidDataException("Only PNG images can be read; this is none.");
        var rest = file[Signature.Length..];
        while (rest.Length >= LengthAndName + 4)
        {
            var length = BinaryPrimitives.ReadUInt32BigEndian(rest.Span);
            if (length > rest.Length - LengthAndName - 4)
                throw new InvalidDataException("The PNG image ends in the middle.");
            var name = Encoding.ASCII.GetString(rest.Span[4..LengthAndName]);
            if (name == "IEND")
                yield break;
            yield return new PngChunk(name, rest.Slice(LengthAndName, (int)length));
            rest = rest[(LengthAndName + (int)length + 4)..];
        }
    }

    public static void Write(Stream stream, ReadOnlySpan<byte> name, ReadOnlySpan<byte> data)
    {
        Span<byte> number = stackalloc byte[4];
        BinaryPrimitives.WriteInt32BigEndian(number, data.Length);
        stream.Write(number);
        stream.Write(name);
        stream.Write(data);
        BinaryPrimitives.WriteUInt32BigEndian(number, Crc32.Compute(name, data));
        stream.Write(number);
    }
}
