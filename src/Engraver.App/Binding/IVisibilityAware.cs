namespace Engraver.App.Binding;

/// <summary>State of a page that computes nothing while the page is hidden and is updated when it becomes visible.</summary>
public interface IVisibilityAware
{
    /// <summary>The page is in front and its panel is open.</summary>
    bool IsPageVisible { get; set; }
}
