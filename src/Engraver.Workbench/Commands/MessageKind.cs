using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Motion;
using Engraver.Workbench.Certificates;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Commands.Settings;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Histories;
using Engraver.Workbench.Machines;
using Engraver.Workbench.Machines.Alarms;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Playback;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Views;

namespace Engraver.Workbench.Commands;

public enum MessageKind
{
    /// <summary>A prompt and its input.</summary>
    Echo,

    /// <summary>The requested output of a command: figures, lists, program text.</summary>
    Result,

    /// <summary>Additional information from a command.</summary>
    Note,

    Warning,

    /// <summary>A finding of severity error, or invalid input.</summary>
    Error,
}
