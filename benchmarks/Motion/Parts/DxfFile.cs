using System.Globalization;
using System.Text;

namespace Engraver.Benchmarks.Motion.Parts;

/// <summary>Writes the drawing of a part as DXF in millimetres.</summary>
internal sealed class DxfFile
{
    private readonly StringBuilder _text = new("0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1015\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n");

    public void Line(double x1, double y1, double x2, double y2) => Write("LINE", $"10\n{x1:R}\n20\n{y1:R}\n30\n0\n11\n{x2:R}\n21\n{y2:R}\n31\n0\n");

    /// <param name="start">Degrees.</param>
    /// <param name="end">Degrees, to the left of the start.</param>
    public void Arc(double x, double y, double radius, double start, double end) =>
        Write("ARC", $"10\n{x:R}\n20\n{y:R}\n30\n0\n40\n{radius:R}\n50\n{start:R}\n51\n{end:R}\n");

    public void Circle(double x, double y, double radius) => Write("CIRCLE", $"10\n{x:R}\n20\n{y:R}\n30\n0\n40\n{radius:R}\n");

    public void Add(Outline outline)
    {
        Write("LWPOLYLINE", $"90\n{outline.Vertices.Count}\n70\n{(outline.IsClosed ? 1 : 0)}\n");
        foreach (var (x, y, bulge) in outline.Vertices) _text.Append(CultureInfo.InvariantCulture, $"10\n{x:R}\n20\n{y:R}\n42\n{bulge:R}\n");
    }

    public void Save(string name) => File.WriteAllText(name, _text + "0\nENDSEC\n0\nEOF\n");

    private void Write(string kind, FormattableString codes) =>
        _text.Append(CultureInfo.InvariantCulture, $"0\n{kind}\n8\n0\n").Append(codes.ToString(CultureInfo.InvariantCulture));
}
