using System.Globalization;
using Engraver.Core.Diagnostics;

namespace Engraver.Core.Posts.Agie;

/// <summary>Links the programs of several contours into one: positioning blocks between them, new block numbers, one start and one end (paper 000,
/// LINK).</summary>
public static class AgieLink
{
    /// <summary>The linked program, in the order given. Rounding in positioning is compensated at the next link.</summary>
    /// <param name="contours">Contours, at least one.</param>
    public static PostOutput Link(IReadOnlyList<AgieContour> contours)
    {
        ArgumentNullException.ThrowIfNull(contours);
        ArgumentOutOfRangeException.ThrowIfZero(contours.Count);
        var steps = new AgieSteps(contours[0].Start);
        for (var i = 0; i < contours.Count; i++)
        {
            steps.For = (i, -1);
            steps.Line(steps.Of(contours[i].Start) - steps.Place, drawn: null);
            foreach (var block in contours[i].Blocks) steps.Add(block, drawn: null);
        }

        if (steps.TooMany) return new PostOutput([], [PostRules.TooManyBlocks.At(default, AgieSteps.MaxCount.ToString(CultureInfo.InvariantCulture))]);
        return AgieText.Programs(steps.All, AgieText.Parts(steps.All), ownLine: false);
    }
}
