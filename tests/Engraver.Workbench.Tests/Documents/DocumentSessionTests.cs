using Engraver.TestKit;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Workbench.Tests.Documents;

public class DocumentSessionTests
{
    [Property]
    public Property Undo_and_redo_walk_the_same_states_whatever_the_order() =>
        Prop.ForAll(Gen.Choose(-2, 3).ToArrays(), walk =>
        {
            var session = new DocumentSession();
            var (states, at) = (new List<DocumentState> { session.Current }, 0);
            foreach (var step in walk)
            {
                if (step > 0)
                {
                    states.RemoveRange(at + 1, states.Count - at - 1);
                    states.Add(session.Current with { Settings = new DrawingSettings { JoinToleranceMm = states.Count } });
                    session.Commit("STEP", states[++at]);
                }
                else if (step == 0 && session.Redo() is not null) at++;
                else if (step < 0 && session.Undo() is not null) at--;
                if (!ReferenceEquals(session.Current, states[at]) || session.UndoNames.Count() != at || session.RedoNames.Count() != states.Count - 1 - at) return false;
            }

            return true;
        });

    /// <summary>Undo never closes the drawing; it reopens a drawing closed by CLOSE, also after an OPEN of another one.</summary>
    [Fact]
    public void With_a_drawing_open_undo_never_leads_to_none()
    {
        var (one, other) = (new DrawingBuilder().Line(0, 0, 1, 0).Build(), new DrawingBuilder().Line(0, 0, 2, 0).Build());
        var session = new DocumentSession();
        session.Commit("SETTING", session.Current with { Settings = new DrawingSettings { JoinToleranceMm = 0.5 } });
        session.Commit("OPEN", new DocumentState { Drawing = one });
        Assert.Null(session.Undo());
        session.Commit("CLOSE", new DocumentState());
        Assert.Equal("CLOSE", session.Undo());
        Assert.Same(one, session.Current.Drawing);
        session.Redo();
        session.Commit("OPEN", new DocumentState { Drawing = other });
        Assert.Equal("OPEN", session.Undo());
        Assert.Same(one, session.Current.Drawing);
        Assert.Null(session.Undo());
        session.Redo();
        session.Redo();
        Assert.Same(other, session.Current.Drawing);
    }

    [Fact]
    public void A_step_that_changes_nothing_is_none()
    {
        var session = new DocumentSession();
        session.Commit("NOTHING", session.Current with { });

        Assert.Empty(session.UndoNames);
        Assert.Null(session.Undo());
    }
}
