using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Trajectories;

/// <summary>Prompts shared by SACE commands. Lengths are in drawing units, like points.</summary>
internal static class TrajectoryPrompts
{
    /// <summary>Name under which all commands remember the removal radius of the tool.</summary>
    private const string Removal = "SACE.removal";

    private const double Min = 1e-6;

    private const double Max = 1e6;

    /// <summary>The removal radius of the tool.</summary>
    public static Task<double> RemovalRadiusAsync(CommandContext context) => LengthAsync(context, Removal, "Trajectories.RemovalRadius", 0.25);

    /// <summary>The distance between two passes.</summary>
    public static Task<double> OffsetStepAsync(CommandContext context) => LengthAsync(context, "SACE.step", "Trajectories.OffsetStep", 0.25);

    /// <summary>A length above 0, typed or given by two points; Enter repeats the last value.</summary>
    /// <param name="memory">The name under which it is remembered.</param>
    /// <param name="text">Text of the prompt.</param>
    /// <param name="from">First point of the length; null: asks for it too.</param>
    public static async Task<double> LengthAsync(CommandContext context, string memory, string text, double first, Point2D? from = null)
    {
        var prompt = new AmountPrompt(Wording.Get(text), way => way.Length) { Min = Min, Max = Max, Default = context.LastValue(memory, NumberPrompt.Format(first)), From = from };
        while (true)
        {
            switch (await context.ValueAsync(prompt).ConfigureAwait(false))
            {
                case Amount.Number { Value: var length }:
                    context.Remember(memory, NumberPrompt.Format(length));
                    return length;
                case Amount.FirstPoint { Point: var place }: prompt = prompt with { Instruction = Wording.Get("Common.SpecifySecondPoint"), Default = null, From = place }; break;
            }
        }
    }

    /// <summary>The side of an offset for each contour: by a point, or one side for all.</summary>
    public static async Task<Func<SelectedContour, OffsetSide>> SideAsync(CommandContext context, SelectedContours contours)
    {
        var answer = await context.AskAsync(new PointPrompt(Wording.Get("Trajectories.OffsetSide")) { Options = Keyword.List("Left", "Right", "In", "Out") }).ConfigureAwait(false);
        if (answer is Answer<Point2D>.SelectedOption { Option: var named })
        {
            var side = Enum.Parse<OffsetSide>(named);
            return _ => side;
        }

        var place = context.Drawing.Scale.ToMillimetres(((Answer<Point2D>.Value)answer).Result);
        return contour => contours.SideOf(contour, place);
    }
}
