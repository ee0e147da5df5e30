using System.Globalization;
using Engraver.Samples.Geometry;

namespace Engraver.Samples.Dxf;

/// <summary>Pairs in the manner of one DXF version: hands out handles, and leaves out what R12 does not know.</summary>
internal sealed class TagStream(ITagSink sink, DxfVersion version)
{
    private int lastHandle;

    public bool IsR12 => version == DxfVersion.R12;

    public TagStream Text(int code, string value)
    {
        sink.Text(code, value);
        return this;
    }

    public TagStream Real(int code, double value)
    {
        sink.Real(code, value);
        return this;
    }

    public TagStream Integer(int code, int value)
    {
        sink.Integer(code, value);
        return this;
    }

    /// <summary>A point with Z 0: <paramref name="code"/>, then code + 10 and code + 20.</summary>
    public TagStream Point(int code, Point at) => Real(code, at.X).Real(code + 10, at.Y).Real(code + 20, 0);

    /// <summary>The marker of an object's subclass, from R2000 on.</summary>
    public TagStream Subclass(string marker) => IsR12 ? this : Text(100, marker);

    public string NextHandle() => (++lastHandle).ToString("X", CultureInfo.InvariantCulture);

    /// <summary>Begins an object: its type and, from R2000 on, a handle of its own and its owner's.</summary>
    public TagStream Begin(string type, string owner) => Begin(type, owner, IsR12 ? "" : NextHandle());

    public TagStream Begin(string type, string owner, string handle)
    {
        Text(0, type);
        return IsR12 ? this : Text(type == "DIMSTYLE" ? 105 : 5, handle).Text(330, owner);
    }
}
