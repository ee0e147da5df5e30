using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Views;

namespace Engraver.Workbench.Commands;

/// <summary>A one-time object snap typed at a point prompt (<c>per</c>, <c>tan</c>, <c>mid</c>): only this snap applies to the next point, as in
/// AutoCAD.</summary>
internal static class SnapOverride
{
    /// <param name="pending">The pending prompt; null if there is none.</param>
    /// <returns>False if the input is not a snap name: it is then read as an answer.</returns>
    public static bool TrySet(CommandSession session, PendingPrompt? pending, string input)
    {
        if (pending?.Prompt is not { PointRequest.Purpose: PointPurpose.Place } prompt || SnapNames.Find(input) is not { } bits || Keyword.Find(prompt.Options, input) is not null) return false;
        session.View.Change(view => view with { OneTimeSnap = bits });
        session.WriteMessage(MessageKind.Note, Wording.Get("Osnap.OneTime", SnapNames.Text(bits)));
        return true;
    }

    /// <summary>Called when the point was entered or the command has ended.</summary>
    public static void End(CommandSession session) => session.View.Change(view => view with { OneTimeSnap = null });
}
