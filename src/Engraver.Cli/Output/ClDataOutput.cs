using Engraver.Cli.Verbs;
using Engraver.Core.Drawings;
using Engraver.Core.Posts;
using Engraver.Core.Sequencing;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;

namespace Engraver.Cli.Output;

/// <summary>Where the verbs put CL data.</summary>
internal static class ClDataOutput
{
    /// <summary>Writes the sequenced drawing; a drawing from which nothing could be read does not replace what an earlier one left there.</summary>
    /// <param name="path">Null: standard output.</param>
    /// <exception cref="UsageException">The place cannot be written.</exception>
    public static void Write(VerbHost host, string? path, Drawing read, SequencingResult sequence, DrawingSettings settings)
    {
        if (read.HasErrors && sequence.Contours == 0) return;
        host.Write(path, writer => ClData.Write(sequence, settings.Start, writer));
    }
}
