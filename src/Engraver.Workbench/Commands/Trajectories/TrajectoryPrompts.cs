using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>Questions that several SACE commands ask. Lengths are drawing units, as points are.</summary>
internal static class TrajectoryPrompts
{
    /// <summary>Under this name the radius of what the tool removes is remembered, for all commands.</summary>
    public const string Removal = "SACE.removal";

    private const double Least = 1e-6;

    private const double Most = 1e6;

    /// <summary>A length above 0, typed or shown by two points; Enter takes what was used last.</summary>
    /// <param name="memory">The name under which it is remembered.</param>
    /// <param name="text">Of the question.</param>
    /// <param name="from">Where a shown length begins; null: the first point is asked for too.</param>
    public static async Task<double> LengthAsync(CommandContext context, string memory, string text, double first, Point2D? from = null)
    {
        var prompt = new AmountPrompt(Wording.Get(text), way => way.Length) { Least = Least, Most = Most, Default = context.Remembered(memory, NumberPrompt.Show(first)), From = from };
        while (true)
        {
            switch (await context.ValueAsync(prompt).ConfigureAwait(false))
            {
                case Amount.Number { Of: var length }:
                    context.Remember(memory, NumberPrompt.Show(length));
                    return length;
                case Amount.Beginning { At: var place }: prompt = prompt with { Instruction = Wording.Get("Common.SpecifySecondPoint"), Default = null, From = place }; break;
            }
        }
    }

    /// <summary>The side of an offset for each contour: by a point, or named for all.</summary>
    public static async Task<Func<SelectedContour, OffsetSide>> SideAsync(CommandContext context, SelectedContours contours)
    {
        var answer = await context.AskAsync(new PointPrompt(Wording.Get("Trajectories.OffsetSide")) { Options = Keyword.List("Left", "Right", "In", "Out") }).ConfigureAwait(false);
        if (answer is Answer<Point2D>.Chosen { Option: var named })
        {
            var side = Enum.Parse<OffsetSide>(named);
            return _ => side;
        }

        var place = context.Drawing.Scale.ToMillimetres(((Answer<Point2D>.Value)answer).Of);
        return contour => contours.SideOf(contour, place);
    }
}
