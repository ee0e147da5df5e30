using Engraver.Core.Machines;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>Texts of job outcomes: contract words and displayed text.</summary>
public static class OutcomeText
{
    /// <summary>The outcome in the words of the runner's contract.</summary>
    public static string Token(JobOutcome outcome) => outcome switch
    {
        JobOutcome.Complete => "complete",
        JobOutcome.ToolChange => "toolChange",
        JobOutcome.OperatorStop => "operatorStop",
        JobOutcome.Stopped => "stopped",
        JobOutcome.Refused => "refused",
        JobOutcome.Deviated => "deviated",
        _ => "linkLost",
    };

    /// <summary>The displayed text.</summary>
    public static string DisplayText(JobOutcome outcome) => Wording.Get("Outcome." + outcome);

    /// <param name="word">An outcome as the history stores it.</param>
    public static string DisplayText(string word) =>
        word == "begun" ? Wording.Get("Outcome.Begun")
        : Enum.GetValues<JobOutcome>().Where(outcome => Token(outcome) == word).Select(DisplayText).FirstOrDefault(word);
}
