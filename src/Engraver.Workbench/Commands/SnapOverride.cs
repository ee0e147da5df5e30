using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Views;

namespace Engraver.Workbench.Commands;

/// <summary>An object snap that is typed where a place is asked for (<c>per</c>, <c>tan</c>, <c>mid</c>): it alone holds for the next place, as in
/// AutoCAD.</summary>
internal static class SnapOverride
{
    /// <param name="pending">What is asked for; null when nothing is.</param>
    /// <returns>False when the input is none: it is read as an answer.</returns>
    public static bool Take(CommandSession session, PendingAsk? pending, string input)
    {
        if (pending?.Prompt is not { Aim.Use: PointUse.Place } prompt || SnapNames.Find(input) is not { } bits || Keyword.Find(prompt.Options, input) is not null) return false;
        session.View.Change(view => view with { OneTimeSnap = bits });
        session.Say(MessageKind.Note, Wording.Get("Osnap.OneTime", SnapNames.Text(bits)));
        return true;
    }

    /// <summary>The place was given, or the command has ended.</summary>
    public static void End(CommandSession session) => session.View.Change(view => view with { OneTimeSnap = null });
}
