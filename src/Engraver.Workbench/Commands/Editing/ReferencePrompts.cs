using Engraver.Core.Geometry;
using Engraver.Workbench.CommandLanguage;

namespace Engraver.Workbench.Commands.Editing;

/// <summary>The prompts that ROTATE and SCALE share: an amount, or <c>[Copy/Reference]</c> as in AutoCAD.</summary>
internal static class ReferencePrompts
{
    /// <returns>The amount; with a reference, the new value and the value it replaces. Copy is true if the source is kept.</returns>
    /// <param name="ghost">Returns the transformed objects for an amount and a reference (null for none), for the preview.</param>
    public static async Task<(double Value, double? Reference, bool Copy)> AskAsync(CommandContext context, AmountPrompt amount, AmountPrompt reference, AmountPrompt changed, Func<double, double?, IReadOnlyList<Segment>> ghost)
    {
        var asked = amount with { Options = Keyword.List("Copy", "Reference"), Ghost = GhostOf(amount, value => ghost(value, null)) };
        var copy = false;
        while (true)
        {
            switch (await context.AskAsync(asked).ConfigureAwait(false))
            {
                case Answer<Amount>.Value { Result: Amount.Number { Value: var value } }:
                    return (value, null, copy);
                case Answer<Amount>.SelectedOption { Option: "Reference" }:
                    var from = await NumberAsync(context, reference, null).ConfigureAwait(false);
                    return (await NumberAsync(context, changed, value => ghost(value, from)).ConfigureAwait(false), from, copy);
                default:
                    copy = true;
                    break;
            }
        }
    }

    /// <summary>Preview of the amount from the prompt's first point to the cursor; empty if out of range.</summary>
    private static GhostFunction? GhostOf(AmountPrompt prompt, Func<double, IReadOnlyList<Segment>>? ghost) =>
        ghost is null || prompt.From is not { } from ? null : place => prompt.Measure(place - from) is var value && value >= prompt.Min && value <= prompt.Max ? ghost(value) : [];

    /// <summary>The amount as a number; after the first point of a vector asks for the second one.</summary>
    private static async Task<double> NumberAsync(CommandContext context, AmountPrompt prompt, Func<double, IReadOnlyList<Segment>>? ghost)
    {
        while (true)
        {
            switch (await context.ValueAsync(prompt with { Ghost = GhostOf(prompt, ghost) }).ConfigureAwait(false))
            {
                case Amount.Number { Value: var value }: return value;
                case Amount.FirstPoint { Point: var place }: prompt = prompt with { Instruction = Wording.Get("Common.SpecifySecondPoint"), Default = null, From = place }; break;
            }
        }
    }
}
