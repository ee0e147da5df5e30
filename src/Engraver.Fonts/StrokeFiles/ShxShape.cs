namespace Engraver.Fonts.StrokeFiles;

/// <summary>Draws a shape from its codes, for text that runs from left to right.</summary>
internal sealed class ShxShape
{
    private const int MaxDepth = 16;
    private const int MaxCodes = 100_000;

    /// <summary>AutoCAD refuses shapes that save more.</summary>
    private const int MaxPositions = 4;

    /// <summary>Of the bulge that is a half circle.</summary>
    private const double FullBulge = 127;
    private const double Octant = Math.PI / 4;
    private const double OffsetsOfOctant = 256;

    private readonly ShxFile _file;
    private readonly StrokeCollector _strokes = new();
    private readonly Stack<FontPoint> _positions = new();
    private double _scale = 1;
    private bool _isDown;
    private int _codes;

    private ShxShape(ShxFile file) => _file = file;

    /// <returns>The strokes, and where the pen is at the end.</returns>
    /// <exception cref="BrokenFontException">The codes are invalid.</exception>
    public static (IReadOnlyList<GlyphContour> Contours, FontPoint End) Draw(ShxFile file, int number)
    {
        var shape = new ShxShape(file) { _isDown = true };
        shape.Run(number, 0);
        return (shape._strokes.Finish(), shape._strokes.At);
    }

    /// <summary>Scale, position and pen continue in a subshape and after it.</summary>
    private void Run(int number, int depth)
    {
        if (depth > MaxDepth) throw new BrokenFontException("Shapes of the SHX file contain each other.");
        var bytes = new ShxBytes(_file.Shape(number) ?? throw new BrokenFontException($"The SHX file has no shape {number}."));
        while (Next(bytes) is var code && code != (byte)ShxCode.End)
        {
            if (code != (byte)ShxCode.VerticalOnly)
            {
                Do(bytes, code, depth);
                continue;
            }

            // AutoCAD's own fonts have shapes with the code twice, and a shape may end after it.
            var vertical = Next(bytes);
            while (vertical == (byte)ShxCode.VerticalOnly) vertical = Next(bytes);
            if (vertical == (byte)ShxCode.End) return;
            Skip(bytes, vertical);
        }
    }

    private byte Next(ShxBytes bytes) => ++_codes <= MaxCodes ? bytes.Next() : throw new BrokenFontException("A shape of the SHX file has too many codes.");

    private void Do(ShxBytes bytes, byte code, int depth)
    {
        switch ((ShxCode)code)
        {
            case ShxCode.PenDown:
                _isDown = true;
                break;
            case ShxCode.PenUp:
                _isDown = false;
                break;
            case ShxCode.Divide:
                _scale /= Factor(bytes);
                break;
            case ShxCode.Multiply:
                _scale *= Factor(bytes);
                break;
            case ShxCode.Push:
                if (_positions.Count == MaxPositions) throw new BrokenFontException("A shape of the SHX file saves too many positions.");
                _positions.Push(_strokes.At);
                break;
            case ShxCode.Pop:
                if (!_positions.TryPop(out var position)) throw new BrokenFontException("A shape of the SHX file returns to a position that it did not save.");
                _strokes.MoveTo(position);
                break;
            case ShxCode.Subshape:
                Run(SubshapeNumber(bytes), depth + 1);
                break;
            case ShxCode.Displacement:
                Move(bytes.NextSigned(), bytes.NextSigned());
                break;
            case ShxCode.Displacements:
                while (Pair(bytes) is var (x, y) && (x, y) != (0, 0)) Move(x, y);
                break;
            case ShxCode.OctantArc:
                DrawOctantArc(bytes.Next(), bytes.Next());
                break;
            case ShxCode.FractionalArc:
                DrawFractionalArc(bytes.Next(), bytes.Next(), (bytes.Next() << 8) + bytes.Next(), bytes.Next());
                break;
            case ShxCode.BulgeArc:
                MoveInArc(bytes.NextSigned(), bytes.NextSigned(), bytes.NextSigned());
                break;
            case ShxCode.BulgeArcs:
                while (Pair(bytes) is var (x, y) && (x, y) != (0, 0)) MoveInArc(x, y, bytes.NextSigned());
                break;
            default:
                MoveAlong(code >> 4, code & 15);
                break;
        }
    }

    /// <summary>Passes a code and its values.</summary>
    private void Skip(ShxBytes bytes, byte code)
    {
        switch ((ShxCode)code)
        {
            case ShxCode.Divide or ShxCode.Multiply:
                bytes.Take(1);
                break;
            case ShxCode.Subshape:
                SubshapeNumber(bytes);
                break;
            case ShxCode.Displacement or ShxCode.OctantArc:
                bytes.Take(2);
                break;
            case ShxCode.BulgeArc:
                bytes.Take(3);
                break;
            case ShxCode.FractionalArc:
                bytes.Take(5);
                break;
            case ShxCode.Displacements:
                while (Pair(bytes) != (0, 0)) { }
                break;
            case ShxCode.BulgeArcs:
                while (Pair(bytes) != (0, 0)) bytes.Take(1);
                break;
            default:
                break;
        }
    }

    private (sbyte X, sbyte Y) Pair(ShxBytes bytes) => ((sbyte)Next(bytes), (sbyte)Next(bytes));

    private int SubshapeNumber(ShxBytes bytes) => _file.IsUnicode ? bytes.NextUInt16BigEndian() : bytes.Next();

    private static int Factor(ShxBytes bytes) => bytes.Next() is > 0 and var factor ? factor : throw new BrokenFontException("A shape of the SHX file is scaled by zero.");

    /// <summary>A vector in one of sixteen directions, counter-clockwise from the right. They end on a square: the longer of the two parts is the length, the
    /// other one is the same, half of it, or zero.</summary>
    private void MoveAlong(int length, int direction)
    {
        if (length == 0) throw new BrokenFontException("A shape of the SHX file has an unknown code.");
        Move(length * SideOf(direction), length * SideOf((direction + 12) % 16));
    }

    /// <summary>The horizontal part of a direction.</summary>
    private static double SideOf(int direction) => Math.Clamp((4 - Math.Min(direction, 16 - direction)) / 2.0, -1, 1);

    private void Move(double x, double y) => MoveInArc(x, y, 0);

    /// <param name="bulge">127 is a half circle, positive counter-clockwise.</param>
    private void MoveInArc(double x, double y, int bulge)
    {
        var end = new FontPoint(_strokes.At.X + (_scale * x), _strokes.At.Y + (_scale * y));
        if (_isDown) _strokes.ArcTo(end, bulge / FullBulge);
        else _strokes.MoveTo(end);
    }

    private void DrawOctantArc(int radius, byte octants) => DrawArc(radius, StartOf(octants), CountOf(octants), IsClockwise(octants));

    /// <summary>An arc that does not start or end at an octant. The count of octants includes those that it covers partly; an end offset of zero is the end
    /// of the last octant.</summary>
    private void DrawFractionalArc(int startOffset, int endOffset, int radius, byte octants)
    {
        var isClockwise = IsClockwise(octants);
        var (first, last) = (startOffset / OffsetsOfOctant, endOffset == 0 ? 1 : endOffset / OffsetsOfOctant);
        var sweep = CountOf(octants) - 1 + last - first;
        if (sweep <= 0) throw new BrokenFontException("An arc of the SHX file ends before it starts.");
        DrawArc(radius, StartOf(octants) + (isClockwise ? -first : first), sweep, isClockwise);
    }

    private static int StartOf(byte octants) => (octants >> 4) & 7;

    /// <summary>Zero is a whole circle.</summary>
    private static int CountOf(byte octants) => (octants & 7) == 0 ? 8 : octants & 7;

    private static bool IsClockwise(byte octants) => (octants & 0x80) != 0;

    /// <summary>An arc from where the pen is, which is on the circle in the direction <paramref name="start"/> from its centre.</summary>
    /// <param name="start">In octants, as <paramref name="sweep"/>, which is positive.</param>
    private void DrawArc(int radius, double start, double sweep, bool isClockwise)
    {
        if (radius == 0) throw new BrokenFontException("An arc of the SHX file has no radius.");
        // A whole circle is not an arc with two ends: everything over a half is drawn as two arcs.
        var count = sweep > 4 ? 2 : 1;
        var turn = (isClockwise ? -sweep : sweep) * Octant / count;
        var size = radius * _scale;
        var from = _strokes.At;
        var (sin, cos) = Math.SinCos(start * Octant);
        for (var i = 1; i <= count; i++)
        {
            var (endSin, endCos) = Math.SinCos((start * Octant) + (i * turn));
            var end = i == count && sweep >= 8 ? from : new FontPoint(from.X + (size * (endCos - cos)), from.Y + (size * (endSin - sin)));
            if (_isDown) _strokes.ArcTo(end, Math.Tan(turn / 4));
            else _strokes.MoveTo(end);
        }
    }
}
