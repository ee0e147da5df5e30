using System.Text;

namespace Engraver.Samples.Dxf;

/// <summary>Pairs in the binary form of R13 and later: two-byte group codes, little-endian values whose width follows from the code.</summary>
/// <remarks>DXF Reference, "Binary DXF Files" and "Group Code Value Types". Dispose to flush; the stream stays open.</remarks>
internal sealed class BinaryTagSink : ITagSink, IDisposable
{
    private readonly RealFormat format;
    private readonly BinaryWriter writer;

    public BinaryTagSink(Stream stream, RealFormat format)
    {
        this.format = format;
        writer = new BinaryWriter(stream, Encoding.UTF8, leaveOpen: true);
        writer.Write("AutoCAD Binary DXF\r\n\u001a\0"u8);
    }

    public void Text(int code, string value)
    {
        WriteCode(code);
        writer.Write(Encoding.UTF8.GetBytes(value));
        writer.Write((byte)0);
    }

    public void Real(int code, double value)
    {
        WriteCode(code);
        writer.Write(format.Round(value));
    }

    public void Integer(int code, int value)
    {
        WriteCode(code);
        switch (code)
        {
            case >= 90 and <= 99:
                writer.Write(value);
                break;
            case >= 290 and <= 299:
                writer.Write(checked((byte)value));
                break;
            default:
                writer.Write(checked((short)value));
                break;
        }
    }

    public void Dispose() => writer.Dispose();

    private void WriteCode(int code) => writer.Write(checked((ushort)code));
}
