namespace Engraver.Fonts.OpenType.Outlines;

/// <summary>Draws the path operators of a charstring; all operands are relative to the pen's position.</summary>
internal sealed class CharstringPen(IOutlineSink sink)
{
    private FontPoint _at;
    private bool _hasMoved;
    private bool _isOpen;

    public void EndFigure()
    {
        if (_isOpen)
            sink.Close();
        _isOpen = false;
    }

    public void Draw(CharstringOperator operation, ReadOnlySpan<double> a)
    {
        switch (operation)
        {
            // A width may come before the operands of the first move: the move's own are the last ones.
            case CharstringOperator.RMoveTo:
                Need(a, 2);
                MoveBy(a[^2], a[^1]);
                break;
            case CharstringOperator.HMoveTo:
                Need(a, 1);
                MoveBy(a[^1], 0);
                break;
            case CharstringOperator.VMoveTo:
                Need(a, 1);
                MoveBy(0, a[^1]);
                break;
            case CharstringOperator.RLineTo:
                Lines(a);
                break;
            case CharstringOperator.HLineTo or CharstringOperator.VLineTo:
                AlternatingLines(a, operation == CharstringOperator.HLineTo);
                break;
            case CharstringOperator.RRCurveTo:
                Curves(a);
                break;
            case CharstringOperator.RCurveLine:
                Need(a, 2);
                Curves(a[..^2]);
                Lines(a[^2..]);
                break;
            case CharstringOperator.RLineCurve:
                Need(a, 6);
                Lines(a[..^6]);
                Curves(a[^6..]);
                break;
            default:
                DrawSpecialCurves(operation, a);
                break;
        }
    }

    private void DrawSpecialCurves(CharstringOperator operation, ReadOnlySpan<double> a)
    {
        switch (operation)
        {
            case CharstringOperator.HHCurveTo or CharstringOperator.VVCurveTo:
                SameTangents(a, operation == CharstringOperator.HHCurveTo);
                break;
            case CharstringOperator.HVCurveTo or CharstringOperator.VHCurveTo:
                AlternatingTangents(a, operation == CharstringOperator.HVCurveTo);
                break;
            case CharstringOperator.HFlex:
                Need(a, 7);
                CurveBy(a[0], 0, a[1], a[2], a[3], 0);
                CurveBy(a[4], 0, a[5], -a[2], a[6], 0);
                break;
            case CharstringOperator.Flex:
                Need(a, 12);
                Curves(a[..12]);
                break;
            case CharstringOperator.HFlex1:
                Need(a, 9);
                CurveBy(a[0], a[1], a[2], a[3], a[4], 0);
                CurveBy(a[5], 0, a[6], a[7], a[8], -(a[1] + a[3] + a[7]));
                break;
            case CharstringOperator.Flex1:
                Need(a, 11);
                FlexToLevel(a);
                break;
            default:
                throw new BrokenFontException("A glyph uses an operator that is not supported.");
        }
    }

    /// <summary>The last operand applies to the longer direction; in the other one the curve returns to its start.</summary>
    private void FlexToLevel(ReadOnlySpan<double> a)
    {
        double dx = a[0] + a[2] + a[4] + a[6] + a[8], dy = a[1] + a[3] + a[5] + a[7] + a[9];
        var isHorizontal = Math.Abs(dx) > Math.Abs(dy);
        Curves(a[..6]);
        CurveBy(a[6], a[7], a[8], a[9], isHorizontal ? a[10] : -dx, isHorizontal ? -dy : a[10]);
    }

    private void Lines(ReadOnlySpan<double> a)
    {
        for (var i = 0; i + 1 < a.Length; i += 2)
            LineBy(a[i], a[i + 1]);
    }

    private void AlternatingLines(ReadOnlySpan<double> a, bool isHorizontal)
    {
        foreach (var distance in a)
        {
            LineBy(isHorizontal ? distance : 0, isHorizontal ? 0 : distance);
            isHorizontal = !isHorizontal;
        }
    }

    private void Curves(ReadOnlySpan<double> a)
    {
        for (var i = 0; i + 5 < a.Length; i += 6)
            CurveBy(a[i], a[i + 1], a[i + 2], a[i + 3], a[i + 4], a[i + 5]);
    }

    /// <summary>Curves that begin and end in the same direction; an additional operand shifts the first one sideways.</summary>
    private void SameTangents(ReadOnlySpan<double> a, bool isHorizontal)
    {
        var aside = 0.0;
        if (a.Length % 4 == 1)
        {
            aside = a[0];
            a = a[1..];
        }
        for (var i = 0; i + 3 < a.Length; i += 4)
        {
            if (isHorizontal)
                CurveBy(a[i], aside, a[i + 1], a[i + 2], a[i + 3], 0);
            else
                CurveBy(aside, a[i], a[i + 1], a[i + 2], 0, a[i + 3]);
            aside = 0;
        }
    }

    /// <summary>Curves that alternately begin in one direction and end in the other; an additional operand shifts the end of the last one.</summary>
    private void AlternatingTangents(ReadOnlySpan<double> a, bool isHorizontal)
    {
        for (var i = 0; i + 3 < a.Length; i += 4)
        {
            var aside = a.Length - i == 5 ? a[i + 4] : 0;
            if (isHorizontal)
                CurveBy(a[i], 0, a[i + 1], a[i + 2], aside, a[i + 3]);
            else
                CurveBy(0, a[i], a[i + 1], a[i + 2], a[i + 3], aside);
            isHorizontal = !isHorizontal;
        }
    }

    /// <summary>The contour begins with its first piece: a move that nothing follows draws nothing.</summary>
    private void MoveBy(double dx, double dy)
    {
        EndFigure();
        _at = From(_at, dx, dy);
        _hasMoved = true;
    }

    private void LineBy(double dx, double dy)
    {
        Open();
        _at = From(_at, dx, dy);
        sink.LineTo(_at);
    }

    private void CurveBy(double dx1, double dy1, double dx2, double dy2, double dx3, double dy3)
    {
        Open();
        var control1 = From(_at, dx1, dy1);
        var control2 = From(control1, dx2, dy2);
        _at = From(control2, dx3, dy3);
        sink.CubicTo(control1, control2, _at);
    }

    private void Open()
    {
        if (!_hasMoved)
            throw new BrokenFontException("A glyph draws before it moves.");
        if (!_isOpen)
            sink.MoveTo(_at);
        _isOpen = true;
    }

    private static FontPoint From(FontPoint point, double dx, double dy) => new(point.X + dx, point.Y + dy);

    private static void Need(ReadOnlySpan<double> operands, int count)
    {
        if (operands.Length < count)
            throw new BrokenFontException("An operator of a glyph has too few operands.");
    }
}
