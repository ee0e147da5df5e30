using Engraver.Core.Geometry;
using Engraver.Core.Offsets;
using Engraver.Core.Pockets;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Commands.Toolpaths;

/// <summary>Prompts for the parameters of a pocket, with a preview of the passes for Enter. Every answer is remembered.</summary>
/// <param name="contours">Contours of the selection, millimetres.</param>
internal sealed class PocketPrompts(CommandContext context, IReadOnlyList<OffsetContour> contours)
{
    private const string Memory = "POCKET.";
    private const string Wall = "Wall";
    private const string Centre = "Centre";
    private const string Pocket = "Pocket";
    private const string Everything = "Everything";

    private static readonly IReadOnlyList<Keyword> s_options = Keyword.List("From", "Allowance", "Entry", "Job");

    /// <summary>The prompts in their order; From, Allowance, Entry and Job are options of the last but one, the depth.</summary>
    public async Task<PocketRequest> AskAsync()
    {
        context.Remember(Memory + "Job", Pocket); // With the option All the outlines are cut into the wall, so it is chosen each time and not remembered.
        var (from, entry, job) = (Choice("From"), Choice("Entry"), Choice("Job"));
        context.WriteMessage(Wording.Get("Pocket.Settings", Shown(from), First("Allowance"), Shown(entry), Shown(job)));
        await NumberAsync("Diameter", 1e-3, 1e3).ConfigureAwait(false);
        await NumberAsync("Stepover", 0.01, 0.99).ConfigureAwait(false);
        if (await ChoiceAsync("Strategy", "Contour", "Zigzag").ConfigureAwait(false) == "Zigzag") await NumberAsync("Angle", -360, 360).ConfigureAwait(false);
        while (await DepthAsync().ConfigureAwait(false) is { } option) await MoreAsync(option).ConfigureAwait(false);
        if (Number("Depth") > 0.0) await NumberAsync("Step", 1e-3, 1e3, NumberPrompt.Format(Number("Depth"))).ConfigureAwait(false);
        return CurrentRequest();
    }

    private static string Shown(string option) => Keyword.FormatDefault([new Keyword(option)], option);

    /// <returns>The chosen option; null if the depth was entered.</returns>
    private async Task<string?> DepthAsync()
    {
        var prompt = Prompt("Depth", 0, 1e3, First("Depth")) with { Options = s_options };
        switch (await context.AskAsync(prompt).ConfigureAwait(false))
        {
            case Answer<double>.SelectedOption { Option: var option }:
                return option;
            case Answer<double>.Value { Result: var depth }:
                Remember("Depth", depth);
                break;
        }

        return null;
    }

    private async Task MoreAsync(string option)
    {
        switch (option)
        {
            case "From":
                await ChoiceAsync("From", Wall, Centre).ConfigureAwait(false);
                break;
            case "Allowance":
                await NumberAsync("Allowance", 0, Number("Diameter") / 2.0).ConfigureAwait(false);
                break;
            case "Job":
                await ChoiceAsync("Job", Pocket, Everything).ConfigureAwait(false);
                break;
            default:
                if (await ChoiceAsync("Entry", "Plunge", "Ramp", "Helix").ConfigureAwait(false) != "Plunge") await NumberAsync("RampAngle", 0.1, 89).ConfigureAwait(false);
                break;
        }
    }

    private async Task NumberAsync(string name, double min, double max, string? first = null) => Remember(name, await context.ValueAsync(Prompt(name, min, max, context.LastValue(Memory + name) ?? first ?? First(name))).ConfigureAwait(false));

    private NumberPrompt Prompt(string name, double min, double max, string standard)
    {
        var value = NumberPrompt.TryParse(standard, out var known) ? Math.Clamp(known, min, max) : min;
        return new NumberPrompt(Wording.Get("Pocket." + name)) { Default = NumberPrompt.Format(value), Min = min, Max = max, Preview = Preview() };
    }

    private async Task<string> ChoiceAsync(string name, params string[] options)
    {
        var prompt = new ChoicePrompt(Wording.Get("Pocket." + name)) { Options = Keyword.List(options), Default = Choice(name), Preview = Preview() };
        var answer = ((Answer<string>.SelectedOption)await context.AskAsync(prompt).ConfigureAwait(false)).Option;
        context.Remember(Memory + name, answer);
        return answer;
    }

    private void Remember(string name, double value) => context.Remember(Memory + name, NumberPrompt.Format(value));

    private string First(string name) => context.LastValue(Memory + name) ?? NumberPrompt.Format(name switch
    {
        "Diameter" => PocketDefaults.ToolDiameter,
        "Stepover" => PocketDefaults.Stepover,
        "Angle" => PocketDefaults.AngleDegrees,
        "Allowance" => PocketDefaults.Allowance,
        "Depth" => PocketDefaults.Depth,
        "Step" => PocketDefaults.Step,
        "RampAngle" => PocketDefaults.RampAngleDegrees,
        _ => throw new ArgumentOutOfRangeException(nameof(name), name, null),
    });

    /// <summary>The last choice; at first the default.</summary>
    private string Choice(string name) => context.LastValue(Memory + name) ?? name switch
    {
        "Strategy" => PocketDefaults.Strategy.ToString(),
        "From" => PocketDefaults.FromCentre ? Centre : Wall,
        "Entry" => PocketDefaults.Entry.ToString(),
        _ => Pocket,
    };

    private double Number(string name) => NumberPrompt.TryParse(First(name), out var value) ? value : 0.0;

    /// <summary>The answers so far, with defaults for the rest.</summary>
    private PocketRequest CurrentRequest()
    {
        var (radius, depth) = (Number("Diameter") / 2.0, Number("Depth"));
        var options = new PocketOptions
        {
            ToolRadius = radius,
            Stepover = Number("Stepover"),
            Strategy = Enum.Parse<PocketStrategy>(Choice("Strategy")),
            Angle = Angle.FromDegrees(Number("Angle")),
            FromCentre = Choice("From") == Centre,
            Allowance = Math.Min(Number("Allowance"), radius),
            MaxErrorMm = context.Document.Current.Settings.MaxErrorMm,
            JoinToleranceMm = context.Document.Current.Settings.JoinToleranceMm,
        };
        var entry = depth > 0.0 ? Enum.Parse<PocketEntry>(Choice("Entry")) : PocketEntry.Plunge;
        var depths = new PocketDepths { Depth = depth, Step = depth > 0.0 ? Number("Step") : 0.0, Entry = entry, RampAngle = Angle.FromDegrees(Number("RampAngle")) };
        return new PocketRequest(options, depths, IsJob: Choice("Job") != Everything);
    }

    /// <summary>The passes of one level with their links, in drawing units.</summary>
    private GhostFunction Preview()
    {
        var (options, scale) = (CurrentRequest().Options, context.Drawing.Scale);
        return _ => [.. PocketPlanner.Plan(contours, options).Strokes.SelectMany(stroke => stroke.Moves).Select(move => scale.ToDrawing(move.Segment))];
    }
}

/// <summary>The parameters of a pocket.</summary>
/// <param name="IsJob">From now on only the passes are cut, in their order.</param>
internal sealed record PocketRequest(PocketOptions Options, PocketDepths Depths, bool IsJob);
