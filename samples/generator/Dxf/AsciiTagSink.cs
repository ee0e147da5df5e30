using System.Globalization;
using System.Text;

namespace Engraver.Samples.Dxf;

/// <summary>Pairs as text, two lines each, LF, UTF-8 without a byte order mark. Dispose to flush; the stream stays open.</summary>
internal sealed class AsciiTagSink(Stream stream, RealFormat format) : ITagSink, IDisposable
{
    private readonly StreamWriter writer = new(stream, new UTF8Encoding(encoderShouldEmitUTF8Identifier: false), bufferSize: 1 << 16, leaveOpen: true);

    public void Text(int code, string value)
    {
        writer.Write(code.ToString(CultureInfo.InvariantCulture));
        writer.Write('\n');
        writer.Write(value);
        writer.Write('\n');
    }

    public void Real(int code, double value) => Text(code, format.Text(value));

    public void Integer(int code, int value) => Text(code, value.ToString(CultureInfo.InvariantCulture));

    public void Dispose() => writer.Dispose();
}
