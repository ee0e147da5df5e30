using Engraver.Core.Drawings;
using Engraver.Core.TextMarkup;

namespace Engraver.Workbench.Lettering.Paragraphs;

/// <summary>Distances of baselines. The standard distance is 5/3 of the height (DXF reference, "MTEXT", group 44; AutoCAD's help, "-MTEXT", Line
/// Spacing).</summary>
/// <remarks>"At least": below each line is a space of 2/3 of its height, and the next line follows with its highest letter. The extents that AutoCAD writes
/// into drawings (embedded object, groups 42 and 43) agree with this, also for letters that pass the height of capitals. They also show the box: its top is
/// the highest letter of the first line, its bottom the lowest descender; with "exactly", the bottom is 1/3 of the height below the last baseline.</remarks>
internal sealed class LineSpacing
{
    private const double Standard = 5.0 / 3.0;
    private const double ExactDescent = 1.0 / 3.0;
    private const int Exactly = 2;

    private readonly double _unit;
    private readonly double _factor;
    private readonly bool _isExact;

    /// <param name="unit">Height of the entity.</param>
    public LineSpacing(WrittenParagraphs written, double unit)
    {
        _unit = unit;
        _factor = written.LineSpacingFactor > 0.0 ? written.LineSpacingFactor : 1.0;
        _isExact = written.LineSpacingStyle == Exactly;
    }

    /// <summary>From the top of a column to the baseline of its first line.</summary>
    public double First(SetLine line) => RuleOf(line).IsExact ? _unit : line.Ascent;

    public double Between(SetLine above, SetLine line)
    {
        var (factor, isExact) = RuleOf(line);
        var distance = isExact ? factor * Standard * _unit : line.Ascent + SpaceBelow(factor, above.Height, line.Height);
        return line.IsFirst ? distance + above.Paragraph.SpaceAfter + line.Paragraph.SpaceBefore : distance;
    }

    /// <summary>From the baseline of a line to the bottom of the box, if it is the last one.</summary>
    public double Last(SetLine line) => RuleOf(line).IsExact ? ExactDescent * _unit : line.Depth;

    /// <summary>A factor below 3/5 moves a line up; by the lower height, so that a low line after a high one remains below it.</summary>
    private static double SpaceBelow(double factor, double above, double height) =>
        factor * Standard >= 1.0 ? ((factor * Standard) - 1.0) * above : ((factor * Standard) - 1.0) * Math.Min(above, height);

    private (double Factor, bool IsExact) RuleOf(SetLine line) => line.Paragraph.Format switch
    {
        { Spacing: ParagraphSpacing.Multiple, SpacingValue: > 0.0 and var value } => (value, _isExact),
        { Spacing: ParagraphSpacing.Exactly, SpacingValue: > 0.0 and var value } => (value / Standard, true),
        { Spacing: ParagraphSpacing.AtLeast, SpacingValue: > 0.0 and var value } => (value / Standard, false),
        _ => (_factor, _isExact),
    };
}
