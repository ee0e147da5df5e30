using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Settings;

/// <summary>Asks for the first of two points, in drawing units as <see cref="PointPrompt"/>, or for both as <c>X1,Y1:X2,Y2</c>, millimetres as in
/// the option.</summary>
internal sealed record PointOrPairPrompt(string Instruction) : ValuePrompt<(Point2D First, PointPair? Both)>(Instruction)
{
    public override PointRequest PointRequest => PointRequest.Place;

    public override ParsedInput<(Point2D First, PointPair? Both)> Parse(string typed, Point2D lastPoint)
    {
        ArgumentNullException.ThrowIfNull(typed);
        return typed.Contains(':', StringComparison.Ordinal) ? Of(SettingTable.Align.ReadOption(typed), pair => (default, pair)) : Of(new PointPrompt(Instruction).Parse(typed, lastPoint), point => (point, (PointPair?)null));
    }

    private static ParsedInput<(Point2D First, PointPair? Both)> Of<T>(ParsedInput<T> read, Func<T, (Point2D First, PointPair? Both)> both) =>
        read is ParsedInput<T>.Value { Result: var value } ? new ParsedInput<(Point2D First, PointPair? Both)>.Value(both(value)) : new ParsedInput<(Point2D First, PointPair? Both)>.Invalid(((ParsedInput<T>.Invalid)read).Message);
}
