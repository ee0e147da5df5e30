using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;
using FsCheck;
using FsCheck.Fluent;

namespace Engraver.Workbench.Tests.Documents;

public class DocumentSessionTests
{
    [Fact]
    public void Undo_and_redo_walk_the_same_states_whatever_the_order()
    {
        Prop.ForAll(Gen.Choose(-2, 3).ListOf().ToArbitrary(), walk =>
        {
            var session = new DocumentSession();
            var (states, at) = (new List<DocumentState> { session.Current }, 0);
            foreach (var step in walk)
            {
                if (step > 0)
                {
                    states.RemoveRange(at + 1, states.Count - at - 1);
                    states.Add(session.Current with { Settings = new DrawingSettings { JoinToleranceMm = states.Count } });
                    session.Take("STEP", states[++at]);
                }
                else if (step == 0 && session.Redo() is not null) at++;
                else if (step < 0 && session.Undo() is not null) at--;
                if (!ReferenceEquals(session.Current, states[at]) || session.UndoNames.Count() != at || session.RedoNames.Count() != states.Count - 1 - at) return false;
            }

            return true;
        }).QuickCheckThrowOnFailure();
    }

    [Fact]
    public void A_step_that_changes_nothing_is_none()
    {
        var session = new DocumentSession();
        session.Take("NOTHING", session.Current with { });

        Assert.Empty(session.UndoNames);
        Assert.Null(session.Undo());
    }
}
