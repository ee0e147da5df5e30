using Engraver.Core.Diagnostics;
using Engraver.Core.Dxf.Writing;
using Engraver.Core.Machines;

namespace Engraver.Core.Posts;

/// <summary>The sequenced, oriented drawing as DXF (<see cref="ClData"/>).</summary>
public sealed class ClDataPost : IPost
{
    public string Name => "cldata";

    public string Summary => Wording.Get("ClDataPost.Summary");

    public string FileExtension => ".dxf";

    public PostGeometry Geometry => PostGeometry.Curves;

    public MotionStyle? Motion => null;

    public IReadOnlyList<PostOption> Options => [];

    public PostOutput Write(PostRequest request)
    {
        ArgumentNullException.ThrowIfNull(request);
        using var text = new StringWriter { NewLine = "\n" };
        try
        {
            ClData.Write(request.Path, request.SourceOf, text);
        }
        catch (UnwritableEntityException unwritable)
        {
            return new PostOutput([], [PostRules.NotFinite.At(unwritable.Source, UnwritableEntityException.NameOf(unwritable.Source))]);
        }

        return new PostOutput([text.ToString()], []);
    }
}
