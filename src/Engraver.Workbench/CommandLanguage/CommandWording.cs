using Engraver.Core.Diagnostics;

namespace Engraver.Workbench.CommandLanguage;

/// <summary>Advice as it is followed at the command line of the desktop: findings are written in the words of the runner's options, and here those become commands.</summary>
public static class CommandWording
{
    /// <summary>Longer phrases first, for they hold the shorter ones.</summary>
    private static readonly IReadOnlyList<(string Runner, string Desktop)> s_words =
    [
        ("Look at the drawing with engraver info", "Look at the drawing with CHECK"),
        ("name layers with --layers", "switch layers on with LAYER"),
        ("have construction cut with --cut", "have construction cut with CNCCUT and OPEN the drawing again"),
        ("name outlines with --cut (", "have outlines cut with CNCCUT and OPEN the drawing again ("),
        ("leave out by its layer (--skip-layers)", "switch off with LAYER"),
        ("Check the unit (--units mm or --units inch)", "Check the unit (CNCUNITS 4 for mm, 1 for inch, and OPEN the drawing again)"),
        ("give --start near it", "set TOOLSTART near it"),
        ("cut a part of it (--layers)", "cut a part of it (LAYER)"),
        ("leave its type out of --cut", "leave its type out of CNCCUT"),
        ("give --units mm or --units inch", "set CNCUNITS (4 mm, 1 inch) and OPEN the drawing again"),
        ("Leave --recover-arcs out", "Set CNCRECOVER to 0"),
        ("without --recover-arcs", "with CNCRECOVER 0"),
        ("--keep-duplicates", "CNCDUPLICATES 1"),
        ("--join-tolerance", "CNCJOINTOL"),
        ("--max-error", "CNCMAXERR"),
        ("--feed", "CNCFEED"),
    ];

    public static Diagnostic Translate(Diagnostic finding)
    {
        ArgumentNullException.ThrowIfNull(finding);
        var advice = s_words.Aggregate(finding.Rule.Advice, (text, words) => text.Replace(words.Runner, words.Desktop, StringComparison.Ordinal));
        return advice == finding.Rule.Advice ? finding : finding with { Rule = finding.Rule with { Advice = advice } };
    }
}
