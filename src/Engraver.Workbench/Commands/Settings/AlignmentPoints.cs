using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Commands.Settings;

/// <summary>Asks for the points of an alignment. Points that are picked, or typed one by one, are those of the drawing as it is shown; a pair in one line is
/// that of the options <c>--align</c> and <c>--to</c>.</summary>
/// <param name="present">The placement with which the drawing is shown.</param>
internal sealed class AlignmentPoints(CommandContext context, DrawingPlacement present)
{
    private const string Machine = "Machine";

    /// <summary>Two points of the drawing, scaled, mirrored and rotated, millimetres.</summary>
    public Task<PointPair> OfDrawingAsync(CancellationToken cancellation) =>
        AskAsync("CncPlace.EnterAlign", "CncPlace.EnterAlignSecond", SettingTable.Align, [], shown => present.Shape.Apply(context.Drawing.Unplaced(shown)), cancellation);

    /// <summary>Where they are cut, before the drawing is moved and turned over, millimetres.</summary>
    public Task<PointPair> OfMachineAsync(CancellationToken cancellation) =>
        AskAsync("CncPlace.EnterTo", "CncPlace.EnterToSecond", SettingTable.To, Keyword.List(Machine), present.AfterAlignment.Inverse().Apply, cancellation);

    /// <param name="map">From a point as shown to one of the option, millimetres.</param>
    private async Task<PointPair> AskAsync(string first, string second, PointPairSetting setting, IReadOnlyList<Keyword> options, Func<Point2D, Point2D> map, CancellationToken cancellation)
    {
        var word = setting.ToWord(context.Document.Current.Settings);
        var answer = await context.AskAsync(new PointOrPairPrompt(Wording.Get(first)) { Options = options, Default = word is not null && setting.WhyNotOption(word) is null ? word : null }).ConfigureAwait(false);
        if (answer is Answer<(Point2D First, PointPair? Both)>.Value { Result.Both: { } both }) return both;
        var one = answer is Answer<(Point2D First, PointPair? Both)>.Value { Result.First: var picked } ? Scale.ToMillimetres(picked) : await PresentAsync(cancellation).ConfigureAwait(false);
        context.LastPoint = Scale.ToDrawing(one);
        while (true)
        {
            var next = await context.AskAsync(new PointPrompt(Wording.Get(second)) { Options = options, From = Scale.ToDrawing(one) }).ConfigureAwait(false);
            var other = next is Answer<Point2D>.Value { Result: var point } ? Scale.ToMillimetres(point) : await PresentAsync(cancellation).ConfigureAwait(false);
            if (other != one) return new PointPair(map(one), map(other));
            context.WriteMessage(Wording.Get("CncPlace.SamePoint"), MessageKind.Error);
        }
    }

    private DrawingScale Scale => context.Drawing.Scale;

    /// <summary>Where the machine is now, from the work origin.</summary>
    /// <exception cref="CommandException">That is unknown.</exception>
    private async Task<Point2D> PresentAsync(CancellationToken cancellation)
    {
        if (context.Machine.Connection.Description is null) throw new CommandException(CommandFailure.Usage, Wording.Get("Common.NotConnected"));
        await context.Machine.Origins.AskAsync(null, dryRun: true, cancellation).ConfigureAwait(false);
        return context.Machine.Origins.PlaceInDrawing ?? throw new CommandException(CommandFailure.Refused, Wording.Get("CncPlace.PositionUnknown"));
    }
}
