using Engraver.Workbench.Machines.Arming;

namespace Engraver.Cli.Output;

/// <summary>One start check.</summary>
/// <param name="Ok">False: the job does not start.</param>
/// <param name="Warning">It does not prevent the start, but the operator must acknowledge it.</param>
/// <param name="Sentence">What was checked and, if it failed, what to do.</param>
internal sealed record StartCheckJson(bool Ok, bool Warning, string Sentence)
{
    /// <summary>Null when the checks were not run.</summary>
    public static IReadOnlyList<StartCheckJson>? Of(ArmingChecklist? list) => list is null ? null : [.. list.Checks.Select(check => new StartCheckJson(check.Passed, check.IsWarning, check.Message))];
}
