using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Operations;

namespace Engraver.Core.Posts;

/// <summary>One format in which a job is written: an entry of the table of posts (ADR 9).</summary>
public interface IPost
{
    /// <summary>The name as in <c>--target</c>.</summary>
    string Name { get; }

    /// <summary>Description of the output, in one line without a full stop.</summary>
    string Summary { get; }

    /// <summary>Extension of such files, with the point.</summary>
    string FileExtension { get; }

    /// <summary>The input of the post.</summary>
    PostGeometry Geometry { get; }

    /// <summary>The style of the motion program from which it is written; null when it is written from the path in millimetres, independent of the
    /// machine.</summary>
    MotionStyle? Motion { get; }

    /// <summary>Options in addition to the settings of the job; may be empty.</summary>
    IReadOnlyList<PostOption> Options { get; }

    /// <summary>Why a job with operations cannot be written in the format; null where it can.</summary>
    string? OperationsRefusal => Wording.Get("Post.NoOperations");

    /// <summary>What the program of a request can do of operations.</summary>
    OperationSupport SupportOf(PostRequest request) => new(Name);

    PostOutput Write(PostRequest request);

    /// <summary>The findings of <see cref="Write"/>. A post that can determine them without writing overrides this.</summary>
    IReadOnlyList<Diagnostic> Findings(PostRequest request) => Write(request).Diagnostics;
}
