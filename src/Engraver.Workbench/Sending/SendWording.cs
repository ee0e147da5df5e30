namespace Engraver.Workbench.Sending;

/// <summary>Texts of the result of a transmission, for the console and the command line.</summary>
public static class SendWording
{
    public static string Of(SendResult result)
    {
        ArgumentNullException.ThrowIfNull(result);
        return result.Outcome switch
        {
            SendOutcome.Complete => Wording.Get("Sending.Complete", result.Lines, result.Characters, result.Seconds, result.Pauses),
            SendOutcome.Stopped => Wording.Get("Sending.Stopped", result.Lines, result.TotalLines),
            _ => Wording.Get("Sending.Failed", result.Reason, result.Lines, result.TotalLines),
        };
    }
}
